#include "cosim/report/measure/path_error.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "controller/core/timebase.hpp"

namespace armature::cosim {
namespace {

constexpr std::size_t kLongChain = 64;  // paths

double distance_to_segment(const Eigen::Vector3d& start, const Eigen::Vector3d& end, const Eigen::Vector3d& point) {
  const Eigen::Vector3d along = end - start;
  const double square = along.squaredNorm();
  const double share = square > 0 ? std::clamp(along.dot(point - start) / square, 0.0, 1.0) : 0.0;
  return (start + share * along - point).norm();
}

// Of the curve at(0..end), by halving the steps of a search that begins at the nearest of its samples.
template <class At>
double distance_to_curve(At at, double end, double samples, const Eigen::Vector3d& point) {
  constexpr int kHalvings = 40;
  double step = end / samples;
  double best = 0, least = (at(0) - point).norm();
  const auto visit = [&](double u) {
    const double mm = (at(std::clamp(u, 0.0, end)) - point).norm();
    if (mm >= least) return;
    best = std::clamp(u, 0.0, end);
    least = mm;
  };
  for (double i = 1; i <= samples; ++i) visit(i * step);
  for (int i = 0; i < kHalvings; ++i, step /= 2) {
    const double here = best;
    visit(here - step);
    visit(here + step);
  }
  return least;
}

double distance_to_helix(const PositionPath& helix, const Eigen::Vector3d& point) {
  const Eigen::Vector3d axis = helix.x.cross(helix.y);
  const auto at = [&](double phi) -> Eigen::Vector3d {
    return helix.center_mm + helix.radius_mm * (std::cos(phi) * helix.x + std::sin(phi) * helix.y) +
           phi / helix.angle_rad * helix.advance_mm * axis;
  };
  return distance_to_curve(at, helix.angle_rad, std::ceil(10 * helix.angle_rad), point);
}

double distance_to_spline(const PositionPath& path, const Eigen::Vector3d& point) {
  constexpr double kSamples = 16;  // between two points
  const double pieces = static_cast<double>(path.spline->points_mm().size() - 1);
  return distance_to_curve([&](double mm) { return path.spline->position_mm(mm); }, path.length_mm, kSamples * pieces,
                           point);
}

double distance_to_arc(const PositionPath& arc, const Eigen::Vector3d& point) {
  if (arc.advance_mm != 0) return distance_to_helix(arc, point);
  const Eigen::Vector3d from_center = point - arc.center_mm;
  const double u = from_center.dot(arc.x);
  const double v = from_center.dot(arc.y);
  const double height = from_center.dot(arc.x.cross(arc.y));
  double angle = std::atan2(v, u);
  if (angle < 0) angle += 2 * std::numbers::pi;
  if (angle <= arc.angle_rad) return std::hypot(std::hypot(u, v) - arc.radius_mm, height);
  return std::min((point - arc.start_mm).norm(), (point - arc.end_mm).norm());
}

}  // namespace

double distance_mm(const PositionPath& path, const Eigen::Vector3d& point_mm) {
  switch (path.shape) {
    case PositionPath::Shape::kLine:
      break;
    case PositionPath::Shape::kArc:
      return distance_to_arc(path, point_mm);
    case PositionPath::Shape::kSpline:
      return distance_to_spline(path, point_mm);
  }
  return distance_to_segment(path.start_mm, path.end_mm, point_mm);
}

std::int64_t memory_ticks(const RobotSpec& robot) {
  constexpr double kDecayTimes = 16;     // (1 + 16) exp(-16) = 1.9e-6
  constexpr std::int64_t kOnTheWay = 4;  // ticks from a set-point to the encoder reading that first shows it
  double slowest_s = 0;
  for (std::size_t i = 0; i < robot.axis_count; ++i) {
    const DriveSpec& drive = robot.axes[i].drive;
    const double damping = drive.damping;
    const double slower_pole = damping <= 1 ? damping : damping - std::sqrt(damping * damping - 1);
    slowest_s = std::max(slowest_s, 1 / (2 * std::numbers::pi * drive.natural_hz * slower_pole));
  }
  return static_cast<std::int64_t>(std::ceil(kDecayTimes * slowest_s / kTickSeconds)) + kOnTheWay;
}

void PathErrorMeter::add(const MoveStarted& move) {
  if (move.kind == MoveKind::kDwell) return;  // the set-points stay where they are
  const bool was_on_path = on_path_;
  on_path_ = is_path(move.kind) && !move.on_conveyor;
  if (!on_path_) return;
  if (!move.continues || !was_on_path) chains_.emplace_back();
  std::deque<Path>& paths = chains_.back().paths;
  paths.push_back({.path = move.path, .move = move.tag, .start_tick = move.start_tick.value()});
  // A rounded corner belongs to two paths.
  while (paths.size() > kLongChain && move.start_tick.value() - paths[2].start_tick > memory_ticks_) paths.pop_front();
  if (move.kind != MoveKind::kSpline) return;
  std::vector<Eigen::Vector3d> points{move.path.start_mm};
  points.insert(points.end(), move.through.view().begin(), move.through.view().end());
  points.push_back(move.path.end_mm);
  // The controller moves along a spline only if it is one.
  Path& path = paths.back();
  path.curve = std::make_shared<const Spline>(Spline::through(points).value());
  path.path.spline = path.curve.get();
}

void PathErrorMeter::add(const TraceRow& row) {
  const Telemetry& now = row.telemetry;
  const bool moved = last_reference_ && *last_reference_ != now.reference;
  last_reference_ = now.reference;
  if (now.state == MotionState::kFault) {
    on_path_ = false;
    chains_.clear();
  }
  if (on_path_) {
    chains_.back().last_tick = row.tick;
  } else if (moved || now.state == MotionState::kFault) {
    foreign_ = true;
    foreign_tick_ = row.tick;
  }
  std::erase_if(chains_, [&](const Chain& chain) { return row.tick - chain.last_tick > memory_ticks_; });
  if (!row.tool_point) return;
  const auto judge = [&](const Eigen::Vector3d& point, auto first, std::optional<PathDeviation>& largest) {
    std::optional<Nearest> nearest;
    for (auto chain = first; chain != chains_.end(); ++chain) measure(*chain, point, nearest);
    if (!nearest || (largest && nearest->mm <= largest->mm)) return;
    largest = {.mm = nearest->mm, .where = {.tick = row.tick, .at = Cycles{row.cycle}}, .move = nearest->move};
  };
  if (on_path_) judge(row.tool_point->reference_mm, chains_.end() - 1, set_points_);
  if (!foreign_ || row.tick - foreign_tick_ > memory_ticks_) {
    judge(row.tool_point->encoder_mm, chains_.begin(), encoders_);
  }
}

void PathErrorMeter::measure(const Chain& chain, const Eigen::Vector3d& point_mm, std::optional<Nearest>& nearest) {
  for (const Path& path : chain.paths) {
    const double mm = distance_mm(path.path, point_mm);
    if (!nearest || mm < nearest->mm) nearest = Nearest{mm, path.move};
  }
}

}  // namespace armature::cosim
