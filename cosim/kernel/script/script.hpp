// The scenario's moves, faults, inputs and parts in the order of their time.
#pragma once

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "controller/base/units.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// The end of a fault that has a duration.
struct FaultEnd {
  FaultSpec fault;
};

// One set-point of a stream.
struct StreamStep {
  std::size_t stream = 0;  // index in Scenario::streams
  std::size_t point = 0;
  bool more = false;  // the stream goes on behind its points, which are those so far
};

// A part passes the sync point of the conveyor.
struct PartStep {};

using ScriptAction = std::variant<CommandSpec, FaultSpec, FaultEnd, InputSpec, StreamStep, PartStep>;

class Script {
 public:
  explicit Script(const Scenario& scenario);

  // The fault begins at this cycle, which is in the future.
  void insert(Cycles at, const FaultSpec& fault);

  // Cycle of the next action, if there is one.
  [[nodiscard]] std::optional<Cycles> next_event() const;
  // Cycle of the last action that is not removed yet; 0: there is none.
  [[nodiscard]] Cycles last_event() const { return entries_.empty() ? Cycles{} : entries_.back().at; }

  // Removes and returns the next action that is due at `now`. At equal times faults come before inputs, and inputs
  // before moves, moves before set-points of streams, and those before parts.
  std::optional<ScriptAction> pop_due(Cycles now);

  // Adds an action, as if the scenario had it, while the run goes on. Its time is not before the last call of
  // pop_due(). At an equal time it comes after those of the same sort.
  void add(const FaultSpec& fault);
  void add(const InputSpec& input);
  void add(const CommandSpec& command);
  void add(Cycles at, const StreamStep& step);
  // Ends a fault that has begun at `now`, or a cycle after its begin if that is later.
  void end(const FaultSpec& fault, Cycles now);

 private:
  struct Entry {
    Cycles at;
    ScriptAction action;
  };
  void insert(const Entry& entry);
  void forget_past();

  std::vector<Entry> entries_;
  std::size_t next_ = 0;
};

}  // namespace armature::cosim
