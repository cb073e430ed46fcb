#include "cosim/exports/run_times.hpp"

#include <algorithm>

#include "controller/base/timebase.hpp"
#include "cosim/trace/columns.hpp"

namespace armature::cosim {
namespace {

constexpr int kNsDigits = 9;
constexpr std::int64_t kNsPerTick = armature::kTickCycles.value() * kNsPerCycle;

std::int64_t unit_ns(int digits) {
  std::int64_t ns = 1;
  for (int i = digits; i < kNsDigits; ++i) ns *= 10;
  return ns;
}

}  // namespace

std::uint64_t ns_of_cycle(std::int64_t cycle) {
  return static_cast<std::uint64_t>(std::max<std::int64_t>(cycle, 0) * kNsPerCycle);
}

Json time_json(std::uint64_t ns) {
  return {{"sec", ns / kNsPerSecond}, {"nsec", ns % kNsPerSecond}};
}

RunTimes::RunTimes(const TraceTable& trace)
    : time_{trace.column(kTimeColumn)},
      ns_per_unit_{unit_ns(time_.digits)},
      first_tick_{trace.column(kTickColumn).values.front()} {}

std::uint64_t RunTimes::of_row(std::size_t row) const {
  return static_cast<std::uint64_t>(time_.values[row] * ns_per_unit_);
}

std::uint64_t RunTimes::of_tick(std::int64_t tick) const {
  const std::int64_t ns = time_.values.front() * ns_per_unit_ + (tick - first_tick_) * kNsPerTick;
  return static_cast<std::uint64_t>(std::max<std::int64_t>(ns, 0));
}

}  // namespace armature::cosim
