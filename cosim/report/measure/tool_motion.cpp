#include "cosim/report/measure/tool_motion.hpp"

#include "controller/base/timebase.hpp"

namespace armature::cosim {
namespace {

void raise(std::optional<ToolPeak>& peak, double value, const TraceRow& row) {
  if (!peak) peak.emplace();
  if (!(value > peak->value)) return;
  *peak = {.value = value, .at = RunPlace{.tick = row.tick, .at = Cycles{row.cycle}}};
}

}  // namespace

void ToolMotionMeter::add(const TraceRow& row, const Eigen::Vector3d& set_point_mm) {
  const Telemetry& now = row.telemetry;
  const bool known = now.state != MotionState::kFault && (now.referenced & all_axes_) == all_axes_;
  std::optional<Eigen::Vector3d> step_mm;
  if (known && place_mm_) {
    step_mm = set_point_mm - *place_mm_;
    raise(speed_mm_s_, step_mm->norm() / kTickSeconds, row);
    if (step_mm_) raise(accel_mm_s2_, (*step_mm - *step_mm_).norm() / (kTickSeconds * kTickSeconds), row);
  }
  step_mm_ = step_mm;
  place_mm_ = known ? std::optional{set_point_mm} : std::nullopt;
}

}  // namespace armature::cosim
