// Speed and acceleration of the tool centre point by the set-points, in the base frame: differences of the set-points
// of two and of three consecutive ticks. They are not measured across a tick that is in Fault or in which an angle of a
// joint is not known, because the set-points jump there.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "cosim/report/measure/run_place.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

struct ToolPeak {
  double value = 0;
  std::optional<RunPlace> at{};  // the first row in which it was reached; none: it never was above 0
};

class ToolMotionMeter {
 public:
  explicit ToolMotionMeter(std::size_t axis_count) : all_axes_{(1U << axis_count) - 1} {}

  void add(const TraceRow& row, const Eigen::Vector3d& set_point_mm);

  // None: no row was measured.
  [[nodiscard]] const std::optional<ToolPeak>& speed_mm_s() const { return speed_mm_s_; }
  [[nodiscard]] const std::optional<ToolPeak>& accel_mm_s2() const { return accel_mm_s2_; }

 private:
  std::uint32_t all_axes_;                             // mask
  std::optional<Eigen::Vector3d> place_mm_, step_mm_;  // of the row before
  std::optional<ToolPeak> speed_mm_s_, accel_mm_s2_;
};

}  // namespace armature::cosim
