#include "cosim/iss/debug/stop_rules.hpp"

namespace armature::cosim::iss {

void StopRules::set(const Resume& how, std::span<const StopPoint> points) {
  clear();
  for (const StopPoint& point : points) {
    const bool is_breakpoint = point.kind == StopPoint::Kind::kBreakpoint;
    (is_breakpoint ? breakpoints_ : watched_).push_back(point);
    if (is_breakpoint) filter_[filter_bit(point.address)] = true;
  }
  if (how.how == Resume::How::kStep) step_ = how;
  active_ = step_ || !breakpoints_.empty();
}

std::optional<Stop> StopRules::at_instruction(int core, std::uint32_t address) {
  if (filter_[filter_bit(address)]) {
    for (const StopPoint& point : breakpoints_) {
      if (point.address == address) return Stop{.why = Stop::Why::kPoint, .core = core, .point = point};
    }
  }
  if (interrupted_) return Stop{.why = Stop::Why::kInterrupt, .core = core};
  const bool in_range = step_ && step_->first <= address && address < step_->last;
  if (step_ && step_->core == core && !in_range) return Stop{.why = Stop::Why::kStep, .core = core};
  return std::nullopt;
}

std::optional<Stop> StopRules::at_data(int core, const DataAccess& access) const {
  for (const StopPoint& point : watched_) {
    const bool overlaps = access.address < std::uint64_t{point.address} + point.bytes &&
                          point.address < std::uint64_t{access.address} + access.bytes;
    const bool wanted =
        point.kind == StopPoint::Kind::kAccess || (point.kind == StopPoint::Kind::kWrite) == access.write;
    // gdb knows the point by an address inside it.
    if (overlaps && wanted) {
      return Stop{.why = Stop::Why::kPoint,
                  .core = core,
                  .point = point,
                  .data = access.address < point.address ? point.address : access.address};
    }
  }
  return std::nullopt;
}

}  // namespace armature::cosim::iss
