#include "cosim/report/measure/path_error.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "controller/core/timebase.hpp"

namespace armature::cosim {
namespace {

double distance_to_segment(const Eigen::Vector3d& start, const Eigen::Vector3d& end, const Eigen::Vector3d& point) {
  const Eigen::Vector3d along = end - start;
  const double square = along.squaredNorm();
  const double share = square > 0 ? std::clamp(along.dot(point - start) / square, 0.0, 1.0) : 0.0;
  return (start + share * along - point).norm();
}

// By halving the steps of a search around `best`, the sample nearest to the point. `at(u)` is the curve.
template <class At>
double distance_to_curve(At at, double best, double step, const Eigen::Vector3d& point) {
  constexpr int kHalvings = 40;
  double least = (at(best) - point).norm();
  for (int i = 0; i < kHalvings; ++i, step /= 2) {
    for (const double u : {best - step, best + step}) {
      const double mm = (at(u) - point).norm();
      if (mm < least) {
        best = u;
        least = mm;
      }
    }
  }
  return least;
}

double distance_to_helix(const PositionPath& helix, const Eigen::Vector3d& point) {
  const Eigen::Vector3d axis = helix.x.cross(helix.y);
  const auto at = [&](double angle) -> Eigen::Vector3d {
    const double phi = std::clamp(angle, 0.0, helix.angle_rad);
    return helix.center_mm + helix.radius_mm * (std::cos(phi) * helix.x + std::sin(phi) * helix.y) +
           phi / helix.angle_rad * helix.advance_mm * axis;
  };
  constexpr double kStep_rad = 0.1;
  double best = 0, least = (at(0) - point).norm();
  for (double angle = kStep_rad; angle < helix.angle_rad + kStep_rad; angle += kStep_rad) {
    const double mm = (at(angle) - point).norm();
    if (mm < least) {
      best = angle;
      least = mm;
    }
  }
  return distance_to_curve(at, best, kStep_rad, point);
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
  return path.shape == PositionPath::Shape::kArc ? distance_to_arc(path, point_mm)
                                                 : distance_to_segment(path.start_mm, path.end_mm, point_mm);
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
  const bool was_on_path = on_path_;
  on_path_ = move.kind != MoveKind::kJoint;
  if (!on_path_) return;
  if (!move.continues || !was_on_path) chains_.emplace_back();
  chains_.back().paths.push_back({move.path, move.tag.number()});
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
