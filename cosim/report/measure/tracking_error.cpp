#include "cosim/report/measure/tracking_error.hpp"

#include <cmath>

#include "controller/base/timebase.hpp"
#include "cosim/report/measure/path_distance.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {

TrackingErrorMeter::TrackingErrorMeter(const RobotSpec& robot, const ConveyorSpec& conveyor)
    : memory_ticks_{memory_ticks(robot)},
      belt_{conveyor},
      direction_{Eigen::Vector3d{conveyor.direction[0], conveyor.direction[1], conveyor.direction[2]}.normalized()},
      lead_s_{conveyor.lead_ms * 1e-3} {}

void TrackingErrorMeter::add(const MoveStarted& move) {
  if (move.on_conveyor) paths_.push_back({{move.path}, move.tag});
}

void TrackingErrorMeter::add(const PartFollowed& part) {
  switch (part.phase) {
    case PartPhase::kBegun:
      paths_.clear();
      part_ = part.part;
      return;
    case PartPhase::kSynchronised:
      measures_ = true;
      synchronised_tick_ = part.tick.value();
      return;
    case PartPhase::kLeaving:
    case PartPhase::kEnded:
      measures_ = false;
      return;
    case PartPhase::kMissed:
      return;
  }
}

// The telemetry of a row is that of an earlier tick: its set-point is executed two ticks after the encoders were read.
void TrackingErrorMeter::add(const TraceRow& row) {
  if (!measures_ || !row.tool_point || paths_.empty()) return;
  constexpr double kTicksToExecute = 2;
  const double read_s =
      to_seconds(Cycles{row.cycle}) - static_cast<double>(row.tick - row.telemetry.tick.value()) * kTickSeconds;
  judge(row.tool_point->reference_mm, read_s + kTicksToExecute * kTickSeconds + lead_s_, row, set_points_);
  if (row.tick - synchronised_tick_ <= memory_ticks_) return;
  judge(row.tool_point->encoder_mm, read_s, row, encoders_);
}

void TrackingErrorMeter::judge(const Eigen::Vector3d& point_mm, double t_s, const TraceRow& row, Errors& errors) const {
  const Eigen::Vector3d on_part = point_mm - belt_.displacement_mm(part_, t_s) * direction_;
  PathDeviation nearest;
  for (const Path& path : paths_) {
    const double mm = distance_mm(path.path, on_part);
    if (&path != &paths_.front() && mm >= nearest.mm) continue;
    nearest = {.mm = mm, .where = {.tick = row.tick, .at = Cycles{row.cycle}}, .move = path.move};
  }
  if (!errors.largest || nearest.mm > errors.largest->mm) errors.largest = nearest;
  errors.squares_mm2 += nearest.mm * nearest.mm;
  ++errors.count;
}

std::optional<double> TrackingErrorMeter::Errors::rms_mm() const {
  if (count == 0) return std::nullopt;
  return std::sqrt(squares_mm2 / static_cast<double>(count));
}

}  // namespace armature::cosim
