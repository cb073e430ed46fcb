// The fields of the telemetry: all of the block except `published`.
#pragma once

#include "controller/mailbox/event_blocks.hpp"
#include "controller/mailbox/fields_of.hpp"
#include "controller/motion/telemetry.hpp"

namespace armature::mailbox {

template <>
struct FieldsOf<Telemetry> {
  using Block = TelemetryBlock;
  static void transfer(auto copy, auto& block, auto& telemetry) noexcept {
    copy(block.underruns, telemetry.underruns);
    copy(block.tick, telemetry.tick);
    copy(block.state, telemetry.state);
    copy(block.fault, telemetry.fault);
    copy(block.fault_axis, telemetry.fault_axis);
    copy(block.referenced, telemetry.referenced);
    copy(block.sequence, telemetry.sequence);
    copy(block.rate, telemetry.rate);
    copy(block.reference, telemetry.reference);
    copy(block.reference_pulses, telemetry.reference_pulses);
    copy(block.correction, telemetry.correction);
    copy(block.commanded, telemetry.commanded);
    copy(block.encoder, telemetry.encoder);
    copy(block.actual, telemetry.actual);
  }
};

}  // namespace armature::mailbox
