// What a scenario does to the system from outside, and how the system answers: injected faults and inputs of the tool.
//
// The answer to a fault is what happens from its cycle on until the next injected fault, or the end of the run. Lost
// pulses are the exception: each fault counts its own, whenever they come.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "controller/core/axes.hpp"
#include "controller/core/units.hpp"
#include "controller/event/fault.hpp"
#include "controller/event/io_done.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

// A point of simulated time.
struct Moment {
  Cycles at{};
  std::int64_t tick = 0;  // under way then: the row of the trace that shows its end
};

// The controller enters Fault.
struct FaultEvent {
  FaultCause cause = FaultCause::kNone;
  std::uint8_t axis = 0;  // 1..6, 0 when no single axis is to blame
  Cycles at{};
  std::int64_t tick = 0;  // as in Moment
};

struct InjectedFault {
  FaultSpec spec;
  Moment when;
  std::optional<Cycles> released{};        // kEstop: the end of the emergency stop; none: it lasts to the end
  std::int64_t lost_pulses = 0;            // kPulseLoss: of spec.count, so far
  std::int64_t max_correction_pulses = 0;  // kPulseLoss: largest |feedback correction| of its axis
  std::int64_t underruns = 0;              // ticks without committed counts
  std::optional<Cycles> servo_off{};       // a servo enable dropped
  std::optional<FaultEvent> fault{};       // the first one of the controller
};

struct GivenInput {
  InputSpec spec;
  Moment when;
  // The wait_din that then saw the level, before the input changed again; none: none waited for it.
  std::optional<std::uint32_t> accepted_by{};  // index of the move
  Cycles accepted_at{};
};

class InjectionMeter {
 public:
  void add(const FaultSpec& fault, Moment when);
  void release_estop(Cycles at);  // of the earliest emergency stop that lasts
  void add(const InputSpec& input, Moment when);

  void add(const TraceRow& row);
  void add(const MoveSpec& given);
  void add(const IoDone& done, Cycles at);
  void add(const FaultEvent& fault);
  void servo_enables(std::uint8_t levels, Cycles at);

  [[nodiscard]] const std::vector<InjectedFault>& faults() const { return faults_; }
  [[nodiscard]] const std::vector<GivenInput>& inputs() const { return inputs_; }

 private:
  void count_lost_pulses(const TraceRow& row);

  std::vector<InjectedFault> faults_;
  std::vector<GivenInput> inputs_;
  std::vector<std::uint32_t> waits_;  // tags of the wait_din that were given
  std::int64_t underruns_ = 0;        // in all
  std::uint8_t servo_on_ = 0;
};

}  // namespace armature::cosim
