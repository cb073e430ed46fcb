#include "cosim/report/measure/path_error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "controller/base/timebase.hpp"
#include "cosim/report/measure/path_distance.hpp"

namespace armature::cosim {
namespace {

constexpr std::size_t kLongChain = 64;  // paths

}  // namespace

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
  if (!is_path(move.kind) || move.on_conveyor) return leave_path();
  Path path{.path = {move.path}, .move = move.tag, .start_tick = move.start_tick.value()};
  if (move.kind == MoveKind::kSpline) {
    std::vector<Eigen::Vector3d> points{move.path.start_mm};
    points.insert(points.end(), move.through.view().begin(), move.through.view().end());
    points.push_back(move.path.end_mm);
    // The controller moves along a spline only if it is one.
    path.curve = std::make_shared<const Spline>(Spline::through(points).value());
    path.path.spline = path.curve.get();
  }
  start_path(std::move(path), move.continues);
}

void PathErrorMeter::start_path(Path path, bool continues) {
  if (!std::exchange(on_path_, true) || !continues) chains_.emplace_back();
  const std::int64_t start_tick = path.start_tick;
  Chain& chain = chains_.back();
  chain.balls.push_back(ball_around(path.path));
  chain.paths.push_back(std::move(path));
  // A rounded corner belongs to two paths.
  while (chain.paths.size() > kLongChain && start_tick - chain.paths[2].start_tick > memory_ticks_) {
    chain.paths.pop_front();
    chain.balls.erase(chain.balls.begin());
  }
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
  latest_ = {};
  if (!row.tool_point) return;
  const auto judge = [&](const Eigen::Vector3d& point, auto first, std::size_t Chain::*guess,
                         std::optional<PathDeviation>& largest) {
    std::optional<Nearest> nearest;
    for (auto chain = first; chain != chains_.end(); ++chain) measure(*chain, (*chain).*guess, point, nearest);
    if (!nearest) return std::optional<double>{};
    if (!largest || nearest->mm > largest->mm) {
      largest = {.mm = nearest->mm, .where = {.tick = row.tick, .at = Cycles{row.cycle}}, .move = nearest->move};
    }
    return std::optional{nearest->mm};
  };
  if (on_path_)
    latest_.set_point_mm = judge(row.tool_point->reference_mm, chains_.end() - 1, &Chain::near_set_point, set_points_);
  if (!foreign_ || row.tick - foreign_tick_ > memory_ticks_) {
    latest_.encoder_mm = judge(row.tool_point->encoder_mm, chains_.begin(), &Chain::near_encoder, encoders_);
  }
}

// Every path that may be nearest is measured, in the order of the chain: the first of equally near ones counts.
void PathErrorMeter::measure(const Chain& chain, std::size_t& guess, const Eigen::Vector3d& point_mm,
                             std::optional<Nearest>& nearest) {
  const std::size_t guessed = std::min(guess, chain.paths.size() - 1);
  const double guessed_mm = distance_mm(chain.paths[guessed].path, point_mm);
  double least_mm = guessed_mm;
  if (nearest) least_mm = std::min(least_mm, nearest->mm);
  for (std::size_t i = 0; i < chain.balls.size(); ++i) {
    if (chain.balls[i].is_farther(point_mm, least_mm)) continue;
    const double mm = i == guessed ? guessed_mm : distance_mm(chain.paths[i].path, point_mm);
    least_mm = std::min(least_mm, mm);
    if (nearest && !(mm < nearest->mm)) continue;
    nearest = Nearest{mm, chain.paths[i].move};
    guess = i;
  }
}

}  // namespace armature::cosim
