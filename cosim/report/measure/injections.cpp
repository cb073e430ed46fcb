#include "cosim/report/measure/injections.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <variant>

#include "cosim/scenario/command_names.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {

std::optional<std::int64_t> InjectedFault::stop_ticks() const {
  if (!servo_off) return std::nullopt;
  return ((*servo_off - when.at).value() + kTickCycles - 1) / kTickCycles;
}

void InjectionMeter::add(const FaultSpec& fault, const RunPlace& when) {
  faults_.push_back({.spec = fault, .when = when, .answered = servo_on_ == 0});
}

void InjectionMeter::end(const FaultSpec& fault, Cycles at) {
  const auto is_this = [&](const InjectedFault& injected) { return injected.spec == fault && !injected.ended; };
  const auto found = std::ranges::find_if(faults_, is_this);
  if (found != faults_.end()) found->ended = at;
}

void InjectionMeter::add(const InputSpec& input, const RunPlace& when) {
  inputs_.push_back({.spec = input, .when = when});
}

void InjectionMeter::add(const TraceRow& row) {
  const std::int64_t underruns = row.telemetry.underruns;
  if (!faults_.empty()) {
    InjectedFault& last = faults_.back();
    last.underruns += underruns - underruns_;
    if (underruns > underruns_) answer();
    if (const auto* loss = std::get_if<PulseLoss>(&last.spec.kind)) {
      const std::int64_t correction = row.telemetry.correction[static_cast<std::size_t>(loss->axis - 1)].value();
      last.max_correction_pulses = std::max(last.max_correction_pulses, std::abs(correction));
      if (correction != 0) answer();
    }
    if (const auto* extra = std::get_if<ExtraPulses>(&last.spec.kind)) {
      if (row.telemetry.correction[static_cast<std::size_t>(extra->axis - 1)] != Pulses{}) answer();
    }
    count_lost_pulses(row);
  }
  underruns_ = underruns;
}

// The drive loses pulses in the order of the faults.
void InjectionMeter::count_lost_pulses(const TraceRow& row) {
  PerAxis<std::int64_t> to_lose = row.pulses_to_drop;
  for (auto fault = faults_.rbegin(); fault != faults_.rend(); ++fault) {
    const auto* loss = std::get_if<PulseLoss>(&fault->spec.kind);
    if (loss == nullptr) continue;
    std::int64_t& left = to_lose[static_cast<std::size_t>(loss->axis - 1)];
    const std::int64_t not_lost = std::min(left, loss->count);
    fault->lost_pulses = loss->count - not_lost;
    left -= not_lost;
  }
}

void InjectionMeter::add(const CommandSpec& given) {
  if (std::holds_alternative<WaitDinSpec>(given.kind)) wait_tags_.push_back(given.index);
}

void InjectionMeter::add(const IoDone& done, Cycles at) {
  const std::optional<std::uint32_t> index = move_index(done.tag);
  if (!index || std::ranges::find(wait_tags_, *index) == wait_tags_.end()) return;
  GivenInput* const input = not_accepted(done.pin);
  if (input == nullptr || input->spec.level != done.level) return;
  input->accepted_by = *index;
  input->accepted_at = at;
}

// A wait of the program whose condition holds accepts the levels of all inputs that it has read.
void InjectionMeter::add(const ProgramNoted& note, Cycles at) {
  if (note.kind != ProgramNoted::Kind::kWaited || note.text_size > 0) return;
  for (std::int64_t pin = 1; pin <= kToolPins; ++pin) {
    if ((note.inputs >> (pin - 1) & 1) == 0) continue;
    if (GivenInput* const input = not_accepted(pin)) {
      input->accepted_by_line = note.place;
      input->accepted_at = at;
    }
  }
}

// The last change of this pin, which set its level; null: there is none, or it was accepted.
GivenInput* InjectionMeter::not_accepted(std::int64_t pin) {
  const auto found =
      std::find_if(inputs_.rbegin(), inputs_.rend(), [&](const GivenInput& input) { return input.spec.pin == pin; });
  return found == inputs_.rend() || found->accepted() ? nullptr : &*found;
}

void InjectionMeter::add(const FaultEvent& fault) {
  if (!faults_.empty() && !faults_.back().fault) faults_.back().fault = fault;
  answer();
}

void InjectionMeter::add(const BusAbortEvent&) {
  answer();
}

// Of everything but the end of all servo enables.
void InjectionMeter::answer() {
  if (faults_.empty() || std::holds_alternative<Estop>(faults_.back().spec.kind)) return;
  faults_.back().answered = true;
}

void InjectionMeter::servo_enables(std::uint8_t levels, Cycles at) {
  const bool dropped = (servo_on_ & ~levels) != 0;
  servo_on_ = levels;
  if (!dropped || faults_.empty()) return;
  if (!faults_.back().servo_off) faults_.back().servo_off = at;
  answer();
  if (levels == 0) faults_.back().answered = true;
}

}  // namespace armature::cosim
