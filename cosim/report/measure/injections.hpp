// The injected faults of a scenario and its changes of the tool's inputs, with the response of the system to each.
//
// The response to a fault is what happens from its cycle until the next injected fault or the end of the run. Only lost
// pulses are counted differently: each fault counts those that it causes, even after the next fault.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/message/fault.hpp"
#include "controller/message/io_done.hpp"
#include "cosim/report/measure/run_events.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

struct InjectedFault {
  FaultSpec spec;
  RunPlace when;
  std::optional<Cycles> ended{};           // of a fault with a duration; none: it lasts to the end of the run
  std::int64_t lost_pulses = 0;            // PulseLoss: of its count, so far
  std::int64_t max_correction_pulses = 0;  // PulseLoss: largest |feedback correction| of its axis
  std::int64_t underruns = 0;              // ticks without committed counts
  std::optional<Cycles> servo_off{};       // a servo enable dropped
  std::optional<FaultEvent> fault{};       // the first one of the controller
  // Something responded: the controller reported a fault, a servo enable dropped, a core stopped, a tick underran, or
  // the feedback corrected lost or extra pulses. An Estop is answered only when all servo enables are low. A fault that
  // comes while they are low needs no response.
  bool answered = false;

  // From its begin to servo_off, in ticks that have begun.
  [[nodiscard]] std::optional<std::int64_t> stop_ticks() const;
};

struct GivenInput {
  InputSpec spec;
  RunPlace when;
  // The move `wait_din`, or the line of the program, that accepted the level before the input changed again. Neither:
  // nothing waited for it.
  std::optional<std::uint32_t> accepted_by{};       // index of the move
  std::optional<std::uint32_t> accepted_by_line{};  // place in the program
  Cycles accepted_at{};

  [[nodiscard]] bool accepted() const { return accepted_by || accepted_by_line; }
};

class InjectionMeter {
 public:
  void add(const FaultSpec& fault, const RunPlace& when);
  void end(const FaultSpec& fault, Cycles at);  // of a fault that was added
  void add(const InputSpec& input, const RunPlace& when);

  void add(const TraceRow& row);
  void add(const CommandSpec& given);
  void add(const IoDone& done, Cycles at);
  void add(const ProgramNoted& note, Cycles at);
  void add(const FaultEvent& fault);
  void add(const BusAbortEvent& abort);
  void servo_enables(std::uint8_t levels, Cycles at);

  [[nodiscard]] const std::vector<InjectedFault>& faults() const { return faults_; }
  [[nodiscard]] const std::vector<GivenInput>& inputs() const { return inputs_; }

 private:
  void answer();
  [[nodiscard]] GivenInput* not_accepted(std::int64_t pin);
  void count_lost_pulses(const TraceRow& row);

  std::vector<InjectedFault> faults_;
  std::vector<GivenInput> inputs_;
  std::vector<std::uint32_t> wait_tags_;  // tags of the wait_din commands of the scenario
  std::int64_t underruns_ = 0;            // in all
  std::uint8_t servo_on_ = 0;
};

}  // namespace armature::cosim
