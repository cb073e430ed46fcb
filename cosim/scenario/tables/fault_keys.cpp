// [[fault]]: what goes wrong during a run.
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/scenario/tables/tables.hpp"

namespace armature::cosim {

const KeyTable<FaultSpec>& fault_keys() {
  static const KeyTable<FaultSpec> kTable{
      .text = "Each table injects a fault.",
      .keys = {
          at_key<FaultSpec>("The fault begins at this time."),
          named_key("kind", &FaultSpec::kind, kFaultKindNames,
                    "`pulse_loss`: a drive does not see some pulses. `slow_core`: core 0 computes longer from then on. "
                    "`estop`: somebody presses the emergency stop.")
              .required(),
          key("axis", &FaultSpec::axis, between(1, kAxes), "The drive of this axis loses the pulses.")
              .required()
              .only(when("kind", {"pulse_loss"})),
          key("count", &FaultSpec::count, between(1, kMaxCount, "pulses"),
              "The drive loses the next pulses, this many.")
              .required()
              .only(when("kind", {"pulse_loss"})),
          key("compute_us", &FaultSpec::compute_us, above(0, 1'000'000, "us"),
              "Core 0 computes each tick in this time.")
              .required()
              .only(when("kind", {"slow_core"})),
          key("duration_s", &FaultSpec::duration_s, above(0, kMaxDurationS, "s"),
              "The emergency stop stays pressed for this time.")
              .required()
              .only(when("kind", {"estop"})),
      }};
  return kTable;
}

}  // namespace armature::cosim
