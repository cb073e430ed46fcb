// The distance of the tool centre point from its paths on a part that moves with the conveyor. The computation uses
// the true motion of the belt; from the controller it uses only the geometry of each path (MoveStarted::path).
//
// It is measured from the moment on at which the arm is synchronised with the part (set-points) or from the moment on
// at which the drives have settled after that (encoders, memory_ticks()), until the arm leaves the part. A set-point is
// compared with the part when the drives execute it. The error is the distance to the nearest path on this part.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "controller/message/move_started.hpp"
#include "controller/message/part_followed.hpp"
#include "cosim/belt/belt_motion.hpp"
#include "cosim/report/measure/path_error.hpp"
#include "cosim/robot/robot_spec.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

class TrackingErrorMeter {
 public:
  TrackingErrorMeter(const RobotSpec& robot, const ConveyorSpec& conveyor);

  void add(const MoveStarted& move);  // both before the row of their tick
  void add(const PartFollowed& part);
  void add(const TraceRow& row);  // measures only rows with a tool point

  // The largest of the run; none: no row was measured.
  [[nodiscard]] const std::optional<PathDeviation>& of_set_points() const { return set_points_.largest; }
  [[nodiscard]] const std::optional<PathDeviation>& of_encoders() const { return encoders_.largest; }
  // Over all measured rows.
  [[nodiscard]] std::optional<double> rms_of_set_points_mm() const { return set_points_.rms_mm(); }
  [[nodiscard]] std::optional<double> rms_of_encoders_mm() const { return encoders_.rms_mm(); }

 private:
  struct Path {
    PositionPath path;
    Tag move{};
  };
  struct Errors {
    std::optional<PathDeviation> largest;
    double squares_mm2 = 0;
    std::int64_t count = 0;

    [[nodiscard]] std::optional<double> rms_mm() const;
  };
  void judge(const Eigen::Vector3d& point_mm, double t_s, const TraceRow& row, Errors& errors) const;

  std::int64_t memory_ticks_;
  BeltMotion belt_;
  Eigen::Vector3d direction_;
  double lead_s_;
  std::size_t part_ = 0;
  std::vector<Path> paths_;  // on this part
  bool measures_ = false;
  std::int64_t synchronised_tick_ = 0;
  Errors set_points_, encoders_;
};

}  // namespace armature::cosim
