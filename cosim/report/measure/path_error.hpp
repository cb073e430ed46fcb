// How far the tool centre point is from the path that was asked for, by arithmetic of its own: only the geometry that
// the controller reports (MoveStarted::path, corners not rounded) is taken from it.
//
// Moves that are blended form a chain; a point's error is its distance to the nearest of the paths of its chain that
// have begun. The set-points are judged from the first one of a chain until a joint move or a fault; after the plan's
// end they stand on its last point.
//
// The encoders follow the set-points with a lag. What they show is judged when all set-points that a drive has not
// forgotten (within 2e-6 of the way) belong to paths, against the nearest of these: while the drives still follow after
// the plan's end, and for a move right after another one. Right after a joint move it is judged when the drives
// have forgotten that, some 65 ms with a position loop of 40 Hz.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "controller/core/units.hpp"
#include "controller/event/move_started.hpp"
#include "controller/trajectory/path/position_path.hpp"
#include "cosim/scenario/robot_spec.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

struct PathDeviation {
  double mm = 0;
  std::int64_t tick = 0;   // of the row where it was largest
  Cycles at{};             // its trigger
  std::uint32_t move = 0;  // tag of the move whose path is nearest there
};

// Distance of a point from the curve itself, not from the line or circle that it is a part of.
[[nodiscard]] double distance_mm(const PositionPath& path, const Eigen::Vector3d& point_mm);

// Ticks after which a drive has forgotten a set-point: its response to it has decayed to 2e-6, or less.
[[nodiscard]] std::int64_t memory_ticks(const RobotSpec& robot);

class PathErrorMeter {
 public:
  explicit PathErrorMeter(const RobotSpec& robot) : memory_ticks_{memory_ticks(robot)} {}

  void add(const MoveStarted& move);  // before the row of the tick in which it starts
  void add(const TraceRow& row);      // rows without a tool point are not judged

  // The largest of the run; none: nothing was judged.
  [[nodiscard]] const std::optional<PathDeviation>& of_set_points() const { return set_points_; }
  [[nodiscard]] const std::optional<PathDeviation>& of_encoders() const { return encoders_; }

 private:
  struct Path {
    PositionPath path;
    std::uint32_t move = 0;
  };
  struct Chain {
    std::vector<Path> paths;
    std::int64_t last_tick = 0;  // with set-points on it
  };
  struct Nearest {
    double mm = 0;
    std::uint32_t move = 0;
  };
  static void measure(const Chain& chain, const Eigen::Vector3d& point_mm, std::optional<Nearest>& nearest);

  std::int64_t memory_ticks_;
  std::vector<Chain> chains_;      // that the drives may remember; the last one is current if `on_path_`
  bool on_path_ = false;           // the set-points belong to the last chain
  std::int64_t foreign_tick_ = 0;  // last one in which the set-points moved otherwise
  bool foreign_ = false;           // there was one
  std::optional<PerAxis<Radians>> last_reference_;
  std::optional<PathDeviation> set_points_;
  std::optional<PathDeviation> encoders_;
};

}  // namespace armature::cosim
