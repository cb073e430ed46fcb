#include "cosim/report/measure/injections.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace armature::cosim {

void InjectionMeter::add(const FaultSpec& fault, const RunPlace& when) {
  faults_.push_back({.spec = fault, .when = when});
}

void InjectionMeter::release_estop(Cycles at) {
  const auto lasts = [](const InjectedFault& fault) { return fault.spec.kind == FaultKind::kEstop && !fault.released; };
  const auto found = std::ranges::find_if(faults_, lasts);
  if (found != faults_.end()) found->released = at;
}

void InjectionMeter::add(const InputSpec& input, const RunPlace& when) {
  inputs_.push_back({.spec = input, .when = when});
}

void InjectionMeter::add(const TraceRow& row) {
  const std::int64_t underruns = row.telemetry.underruns;
  if (!faults_.empty()) {
    InjectedFault& last = faults_.back();
    last.underruns += underruns - underruns_;
    if (last.spec.kind == FaultKind::kPulseLoss) {
      const std::int64_t correction = row.telemetry.correction[static_cast<std::size_t>(last.spec.axis - 1)].value();
      last.max_correction_pulses = std::max(last.max_correction_pulses, std::abs(correction));
    }
    count_lost_pulses(row);
  }
  underruns_ = underruns;
}

// The drive loses pulses in the order of the faults.
void InjectionMeter::count_lost_pulses(const TraceRow& row) {
  PerAxis<std::int64_t> to_lose = row.pulses_to_drop;
  for (auto fault = faults_.rbegin(); fault != faults_.rend(); ++fault) {
    if (fault->spec.kind != FaultKind::kPulseLoss) continue;
    std::int64_t& left = to_lose[static_cast<std::size_t>(fault->spec.axis - 1)];
    const std::int64_t not_lost = std::min(left, fault->spec.count);
    fault->lost_pulses = fault->spec.count - not_lost;
    left -= not_lost;
  }
}

void InjectionMeter::add(const MoveSpec& given) {
  if (given.type == MoveType::kWaitDin) waits_.push_back(given.index);
}

void InjectionMeter::add(const IoDone& done, Cycles at) {
  if (std::ranges::find(waits_, done.tag.number()) == waits_.end()) return;
  // The last change of this pin set its level.
  const auto found = std::find_if(inputs_.rbegin(), inputs_.rend(),
                                  [&](const GivenInput& input) { return input.spec.pin == done.pin; });
  if (found == inputs_.rend() || found->spec.level != done.level || found->accepted_by) return;
  found->accepted_by = done.tag.number();
  found->accepted_at = at;
}

void InjectionMeter::add(const FaultEvent& fault) {
  if (!faults_.empty() && !faults_.back().fault) faults_.back().fault = fault;
}

void InjectionMeter::servo_enables(std::uint8_t levels, Cycles at) {
  const bool dropped = (servo_on_ & ~levels) != 0;
  servo_on_ = levels;
  if (dropped && !faults_.empty() && !faults_.back().servo_off) faults_.back().servo_off = at;
}

}  // namespace armature::cosim
