#include "cosim/rewind/run_digest.hpp"

#include <algorithm>
#include <variant>

#include "controller/base/overloaded.hpp"
#include "cosim/logic/pin_table.hpp"
#include "cosim/rewind/state_bytes.hpp"
#include "cosim/serial/serial_log.hpp"

namespace armature::cosim {

void RunDigest::on_row(const TraceRow& row, const IntegerDigest&) {
  begin('r', {.tick = row.tick, .at = Cycles{row.cycle}});
  append_bytes(bytes_, row.telemetry);
  for (const auto* counts : {&row.pin_pulses, &row.pulses_to_drop, &row.motor_counts, &row.first_rise, &row.turned,
                             &row.motor_from, &row.motor_to}) {
    append_bytes(bytes_, *counts);
  }
  for (const CoreLoad& load : row.load) {
    append_bytes(bytes_, load.awake_cycles);
    append_bytes(bytes_, load.bus_cycles);
    append_bytes(bytes_, load.instructions);
  }
  append_bytes(bytes_, row.stopped);
  end();
}

void RunDigest::on_event(const Event& event, const RunPlace& place) {
  begin('e', place);
  append_bytes(bytes_, event.index());
  std::visit([this](const auto& what) { append_bytes(bytes_, what); }, event);
  end();
}

// What the scenario does is known. That it was done counts.
void RunDigest::on_action(const ScriptAction& action, const RunPlace& place) {
  begin('a', place);
  append_bytes(bytes_, action.index());
  end();
}

void RunDigest::on_signal(const Signal& signal, const RunPlace& place) {
  begin('s', place);
  std::visit(Overloaded{
                 [this](const OutputLevel& output) {
                   append_bytes(bytes_, output.pin);
                   append_bytes(bytes_, output.level);
                 },
                 [this](const ServoEnables& enables) { append_bytes(bytes_, enables.levels); },
                 [this](const BusAbort& abort) {
                   append_bytes(bytes_, abort.access.core);
                   append_bytes(bytes_, abort.error);
                 },
                 [this](const SerialEvent& event) { bytes_ += serial_log_row(event); },
                 [this](const PendantStepDone& step) { bytes_ += step.text; },
             },
             signal);
  end();
}

void RunDigest::begin(char kind, const RunPlace& place) {
  ++count_;
  bytes_ = kind;
  append_bytes(bytes_, place.tick);
  append_bytes(bytes_, place.at);
}

void RunDigest::end() {
  heard_.add(bytes_);
}

RunState RunDigest::state(const SimulationState& seen) const {
  std::string bytes = heard_.hex();
  append_bytes(bytes, seen.now);
  append_bytes(bytes, seen.over);
  for (const std::int64_t count : {seen.triggers, seen.bus_reads, seen.bus_writes}) append_bytes(bytes, count);
  for (const Pin& pin : pins()) append_bytes(bytes, pin.get(seen.inputs, seen.outputs));
  append_bytes(bytes, seen.telemetry);
  append_bytes(bytes, seen.drive_pulses);
  append_bytes(bytes, seen.motor_counts);
  append_bytes(bytes, seen.motor_deg);
  append_bytes(bytes, seen.following_error_counts);
  RunState state{.seen = seen, .heard = count_};
  std::ranges::copy(sha256_hex(bytes), state.digest.begin());
  return state;
}

}  // namespace armature::cosim
