// What can be said about a run: each fact with its name, unit and meaning, how it is computed from the measurements,
// and the keys of [expect] that compare it. fact_list() is the only list of them: judging, summary.json, the screen,
// JUnit and scenarios/RESULTS.md go through it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/report/facts/fact_value.hpp"
#include "cosim/report/facts/fact_where.hpp"
#include "cosim/report/measure/run_facts.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

// Where summary.json has a fact, and of which runs.
enum class FactGroup {
  kResult,   // under `result`: of every run
  kPaper,    // under `result.paper`: of the variant of the paper
  kSerial,   // under `result`: if the controller sent something on its serial line
  kOutputs,  // under `result`: if an output of the tool has changed
  kEvents,   // in more detail, among the moves, refused moves and faults
};

// How a value is compared with the expected one.
enum class Relation {
  kEqual,
  // Not farther than a tolerance: each axis; the distance of points; the angle between orientations; the times of
  // output changes.
  kWithin,
  // Not above or below a limit. Of values of all axes, the largest.
  kAtMost,
  kAtLeast,
};

// A key of [expect] that compares a fact.
struct Expectation {
  std::string_view key;
  Relation relation = Relation::kEqual;
  // The expected value, of a robot with that many axes; none: the scenario does not have the key.
  std::optional<FactValue> (*wanted)(const ExpectSpec& expect, std::size_t axis_count) = nullptr;
  // kWithin: the tolerance, in the unit of the fact, and the key that gives it. Empty: no key does.
  double (*tolerance)(const ExpectSpec& expect) = nullptr;
  std::string_view tolerance_key{};
};

// A line of the summary on the screen. Values of axes stand in columns.
struct ScreenLine {
  std::string_view label{};  // empty: no line
  int digits = 0;            // after the point
  bool unless_zero = false;  // no line for 0
};

struct Fact {
  std::string_view name;  // also the key in summary.json
  std::string_view unit;  // empty: none, or counted things that the name says
  std::string_view meaning;
  FactValue (*value)(const RunFacts& facts) = nullptr;
  FactGroup group = FactGroup::kResult;
  ScreenLine screen{};
  std::vector<Expectation> expectations{};

  // ---- for messages about expectations; each may be missing
  // The value in words, where it needs more than value_text().
  std::string (*in_words)(const RunFacts& facts) = nullptr;
  // Why the run has nothing that an expectation could be met by, though there is a value; empty: it has.
  std::string (*nothing_to_judge)(const RunFacts& facts) = nullptr;
  FactWhere (*where)(const RunFacts& facts) = nullptr;
  // Where the value of each axis is from.
  PerAxis<std::optional<RunPlace>> (*axis_places)(const RunFacts& facts) = nullptr;

  // What the value must be when the scenario mentions the fact by none of its expectations, nor by those of the fact
  // `mentioned_by`; none: anything.
  struct Otherwise {
    FactValue value;
    std::string_view text;  // for messages
    std::string_view mentioned_by{};
  };
  std::optional<Otherwise> otherwise{};
};

// All facts, in the order in which reports show them.
[[nodiscard]] const std::vector<Fact>& fact_list();

// The entry of that name, which must exist.
[[nodiscard]] const Fact& fact_named(std::string_view name);

}  // namespace armature::cosim
