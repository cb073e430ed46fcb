// Simulated time in nanoseconds, as messages have it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cosim/recording/trace_table.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {

inline constexpr std::uint64_t kNsPerSecond = 1'000'000'000;

[[nodiscard]] std::uint64_t ns_of_cycle(std::int64_t cycle);

// {"sec": ..., "nsec": ...}
[[nodiscard]] Json time_json(std::uint64_t ns);

// The times of rows and ticks of a trace. Throws InputError if it has no column `time_s` or `tick`.
class RunTimes {
 public:
  explicit RunTimes(const TraceTable& trace);
  [[nodiscard]] std::uint64_t of_row(std::size_t row) const;
  [[nodiscard]] std::uint64_t of_tick(std::int64_t tick) const;

 private:
  const NumberColumn& time_;
  std::int64_t ns_per_unit_;
  std::int64_t first_tick_;
};

}  // namespace armature::cosim
