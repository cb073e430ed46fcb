// The distance of the tool centre point from the commanded path. The computation is independent of the controller,
// except for the geometry of each path (MoveStarted::path, corners not rounded).
//
// Moves that are blended form a chain. The error of a point is its distance to the nearest path of its chain among
// those that have begun. Of a long chain the first paths, to which no drive responds any more, do not count. Set-points
// are measured from the first one of a chain until a joint move or a fault; after the end of the plan they stay on its
// last point.
//
// The encoders lag behind the set-points, because a drive still responds to earlier set-points. Encoders are measured
// while all set-points that a drive still responds to (by more than 2e-6 of the way) belong to paths, against the
// nearest of these paths. So they are measured while the drives settle after the end of a plan, and in a move that
// follows another path at once. After a joint move the measurement begins when the response to that move has decayed,
// some 65 ms with a position loop of 40 Hz.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"
#include "controller/message/move_started.hpp"
#include "controller/trajectory/path/position_path.hpp"
#include "cosim/report/measure/path_distance.hpp"
#include "cosim/report/measure/run_place.hpp"
#include "cosim/robot/robot_spec.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

struct PathDeviation {
  double mm = 0;
  RunPlace where{};  // the row where it was largest
  Tag move{};        // whose path is nearest there
};

// Ticks after which the response of a drive to a set-point has decayed to 2e-6 or less.
[[nodiscard]] std::int64_t memory_ticks(const RobotSpec& robot);

class PathErrorMeter {
 public:
  struct Path {
    PositionPath path;
    Tag move{};
    std::int64_t start_tick = 0;
    std::shared_ptr<const Spline> curve{};  // of `path`, which is a spline
  };
  // In the last row; none: not measured in it.
  struct Errors {
    std::optional<double> set_point_mm{}, encoder_mm{};
  };

  explicit PathErrorMeter(std::int64_t memory_ticks) : memory_ticks_{memory_ticks} {}

  // Before the row of the tick in which the move starts, unless it is a dwell. A path; `continues`: blended.
  void start_path(Path path, bool continues);
  // Another move.
  void leave_path() { on_path_ = false; }
  // Either of them.
  void add(const MoveStarted& move);
  void add(const TraceRow& row);  // measures only rows with a tool point
  [[nodiscard]] const Errors& latest() const { return latest_; }

  // The largest of the run; none: no row was measured.
  [[nodiscard]] const std::optional<PathDeviation>& of_set_points() const { return set_points_; }
  [[nodiscard]] const std::optional<PathDeviation>& of_encoders() const { return encoders_; }

 private:
  struct Chain {
    std::deque<Path> paths;   // of a long chain the last ones
    std::vector<Ball> balls;  // around them
    // The paths that were nearest in the last row: good guesses for the next one.
    std::size_t near_set_point = 0, near_encoder = 0;
    std::int64_t last_tick = 0;  // with set-points on it
  };
  struct Nearest {
    double mm = 0;
    Tag move{};
  };
  static void measure(const Chain& chain, std::size_t& guess, const Eigen::Vector3d& point_mm,
                      std::optional<Nearest>& nearest);

  std::int64_t memory_ticks_;
  std::vector<Chain> chains_;      // that a drive may still respond to; the last one is current if `on_path_`
  bool on_path_ = false;           // the set-points belong to the last chain
  std::int64_t foreign_tick_ = 0;  // last tick in which the set-points moved outside of paths
  bool foreign_ = false;           // there was such a tick
  std::optional<PerAxis<Radians>> last_reference_;
  Errors latest_{};
  std::optional<PathDeviation> set_points_;
  std::optional<PathDeviation> encoders_;
};

}  // namespace armature::cosim
