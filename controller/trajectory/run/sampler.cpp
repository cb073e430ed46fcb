#include "controller/trajectory/run/sampler.hpp"

#include <algorithm>
#include <cstdint>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/plan/rate_bend.hpp"

namespace armature {
namespace {

RateJerk rate_jerk(bool limited, RateJerk kind) {
  return limited ? kind : RateJerk::kAny;
}

// A brake together with the plan's own braking may end a rounding error before the plan does. This counts as the end:
// the rest is less than a_max (kEndTicks Ts)^2 / 2, a millionth of the change allowed in a tick.
constexpr double kEndTicks = 1e-3;

}  // namespace

Sampler::Sampler(const RobotModel& robot, const Arm& arm, const PerAxis<Radians>& position) noexcept
    : robot_{robot}, arm_{arm}, position_{position}, clock_{robot} {}

void Sampler::reset_to(const PerAxis<Radians>& position) noexcept {
  position_ = position;
  busy_ = false;
  rate_ = 0.0;
}

void Sampler::take(const Plan& plan) noexcept {
  plan_ = plan;
  duration_ = duration(plan);
  run_ = {};
  forget_samples();
}

void Sampler::start(const Plan& plan, double rate) noexcept {
  take(plan);
  restart_clock(rate, false);
  busy_ = duration_ > Ticks{0};
}

void Sampler::start_in_motion(const JointChain& chain) noexcept {
  take(Plan{Piece{chain}});
  restart_clock(1.0, busy_);
  busy_ = duration_ > Ticks{0};
}

// Several pieces have the clock of a joint chain of several moves.
void Sampler::restart_clock(double rate, bool in_motion) noexcept {
  const Piece only = plan_.count == 1 ? plan_.pieces[0] : Piece{};
  if (only.path != nullptr) {
    run_ = run_at(*only.path, 0.0);
    clock_.restart(rate, rate_jerk(run_.limits_jerk, RateJerk::kTurning));
  } else if (only.joints != nullptr) {
    clock_.restart(rate, rate_jerk(limits_jerk(*only.joints), RateJerk::kMonotonic));
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const TimeLaw& law = only.joints->profiles[axis];
      if (law.kind == ProfileKind::kSCurve) clock_.set_peak(axis, law.scurve.jerk * law.scurve.jerk_s);
    }
  } else if (only.chain != nullptr && only.chain->count == 1 && only.chain->moves[0].kind == ProfileKind::kSCurve) {
    clock_.restart(rate, RateJerk::kReversing, kAnyBend, in_motion);
    const PerAxis<double>& peak = only.chain->moves[0].peak_accel_rad_s2;
    for (std::size_t axis = 0; axis < kAxes; ++axis) clock_.set_peak(axis, peak[axis]);
  } else {
    clock_.restart(rate, RateJerk::kAny, rate_bend(plan_, robot_), in_motion);
  }
}

bool Sampler::can_continue_with(const CartesianPlan& next) const noexcept {
  const double ticks = clock_.time() - static_cast<double>(next.origin.value());
  // A change of the rate that does not limit the jerk continues as it is.
  const bool may_change = clock_.steady() || run_.limits_jerk || !next.first_run.limits_jerk;
  return busy_ && may_change && ticks >= CartesianPlan::kLeastTicks && ticks <= next.same_until_ticks;
}

bool Sampler::missed(const CartesianPlan& next) const noexcept {
  return !busy_ || clock_.time() - static_cast<double>(next.origin.value()) > next.same_until_ticks;
}

void Sampler::continue_with(const CartesianPlan& next) noexcept {
  take(Plan{Piece{next}});
  clock_.move_origin(next.origin);
  run_ = next.first_run;
  clock_.continue_with_jerk(rate_jerk(run_.limits_jerk, RateJerk::kTurning));
}

const PerAxis<Radians>& Sampler::advance(double rate) noexcept {
  inverses_ = 0;
  rate_ = 0.0;
  if (!busy_) return position_;
  if (const CartesianPlan* path = plan_.only_path(); path != nullptr && clock_.time() >= run_.end_ticks) {
    run_ = run_at(*path, clock_.time());
    clock_.set_jerk(rate_jerk(run_.limits_jerk, RateJerk::kTurning));
  }
  position_ = clock_.advance(
      rate, position_, [this](double ticks) { return at(ticks); },
      [this](double from, double to) { return tool_step(from, to); }, [this] { return may_try(); },
      [this](double from, double to) { return plan_jerk(from, to); });
  finish_if_over();
  return position_;
}

const PerAxis<Radians>& Sampler::brake() noexcept {
  inverses_ = 0;
  rate_ = 0.0;
  if (!busy_) return position_;
  position_ = clock_.advance_hard(
      0.0, position_, [this](double ticks) { return at(ticks); }, [this] { return may_try(); });
  finish_if_over();
  return position_;
}

PerAxis<AxisState> Sampler::state() const noexcept {
  if (!busy_) return make_per_axis([&](std::size_t axis) { return AxisState{.position = position_[axis].value()}; });
  const Piece& piece = plan_.piece_at(clock_.time());
  if (piece.path == nullptr && clock_.steady()) {
    const double t_s = piece.own_ticks(clock_.time()) * kTickSeconds, rate = clock_.rate();
    auto state = piece.chain != nullptr ? state_at(*piece.chain, t_s) : state_at(*piece.joints, t_s);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      state[axis].position = position_[axis].value();
      state[axis].velocity *= rate;
      state[axis].accel *= rate * rate;
    }
    return state;
  }
  return make_per_axis([&](std::size_t axis) {
    const double now = position_[axis].value(), previous = now - clock_.step_rad()[axis];
    const double oldest = previous - clock_.previous_step_rad()[axis];
    return state_after(now, previous, oldest, kTickSeconds);
  });
}

void Sampler::finish_if_over() noexcept {
  rate_ = clock_.rate();
  busy_ = clock_.time() < static_cast<double>(duration_.value()) - kEndTicks;
  if (!busy_) position_ = target_of(plan_);
}

PerAxis<Radians> Sampler::at(double ticks) noexcept {
  const Piece& piece = plan_.piece_at(ticks);
  const double t_s = piece.own_ticks(ticks) * kTickSeconds;
  if (const CartesianPlan* path = piece.path) {
    return armature::position(*path, t_s, position_, inverses_, [&] {
      const Transform base_T_tool = tool_at(*path, piece.own_ticks(ticks)).tool.base_T_tool;
      return follow_tool(*path, arm_, t_s, base_T_tool, position_);
    });
  }
  if (piece.chain != nullptr) return armature::position(*piece.chain, t_s);
  return armature::position(*piece.joints, t_s);
}

// Scaled by the larger limits of all segments that have been active since the previous set-point. Nothing where the
// piece changes: the rate is then constant for that tick.
ToolStep Sampler::tool_step(double from, double to) noexcept {
  const Piece& piece = plan_.piece_at(from);
  const CartesianPlan* path = piece.path;
  if (path == nullptr || path != plan_.piece_at(to).path) return {};
  from = piece.own_ticks(from);
  to = piece.own_ticks(to);
  const double clock_ticks = piece.own_ticks(clock_.time());
  double accel_mm_s2 = 0.0, turn_accel_rad_s2 = 0.0, jerk_mm_s3 = 0.0, turn_jerk_rad_s3 = 0.0;
  bool limits_jerk = true;
  for (std::size_t i = segment_at(*path, clock_ticks * kTickSeconds) + 1; i-- > 0;) {
    const CartesianSegment& segment = path->segments[i];
    if (static_cast<double>(end_of(segment).value()) <= clock_ticks - clock_.rate()) break;
    accel_mm_s2 = std::max(accel_mm_s2, segment.limits.accel_mm_s2);
    turn_accel_rad_s2 = std::max(turn_accel_rad_s2, segment.limits.turn_accel_rad_s2);
    jerk_mm_s3 = std::max(jerk_mm_s3, segment.limits.jerk_mm_s3);
    turn_jerk_rad_s3 = std::max(turn_jerk_rad_s3, segment.limits.turn_jerk_rad_s3);
    limits_jerk = limits_jerk && segment.profile == ProfileKind::kSCurve;
  }
  if (accel_mm_s2 == 0.0) return {};  // beyond the end
  const ToolSample& first = tool_at(*path, from);
  const ToolSample& second = tool_at(*path, to, &first);
  const Eigen::Vector3d move_mm = second.tool.base_T_tool.position_mm - first.tool.base_T_tool.position_mm;
  constexpr double kTick2 = kTickSeconds * kTickSeconds;
  ToolStep step{.move = move_mm / (accel_mm_s2 * kTick2),
                .turn = limited_turn(first, second) / (turn_accel_rad_s2 * kTick2)};
  if (limits_jerk) {
    step.move_jerk = jerk_mm_s3 / accel_mm_s2 * kTickSeconds;
    step.turn_jerk = turn_jerk_rad_s3 / turn_accel_rad_s2 * kTickSeconds;
  }
  return step;
}

const ToolSample& Sampler::tool_at(const CartesianPlan& path, double ticks, const ToolSample* keep) noexcept {
  for (std::size_t i = 0; i < sample_count_; ++i) {
    if (samples_[i].path == &path && samples_[i].ticks == ticks) return samples_[i].tool;
  }
  if (&samples_[oldest_sample_].tool == keep) oldest_sample_ = (oldest_sample_ + 1) % samples_.size();
  Sample& sample = samples_[oldest_sample_];
  oldest_sample_ = (oldest_sample_ + 1) % samples_.size();
  sample_count_ = std::min(sample_count_ + 1, samples_.size());
  sample = {&path, ticks, tool_sample(path, ticks * kTickSeconds)};
  return sample.tool;
}

void Sampler::forget_samples() noexcept {
  sample_count_ = oldest_sample_ = 0;
}

// For the clocks that limit the jerk: those of plans of one piece, which is no chain of several moves.
double Sampler::plan_jerk(double from, double to) const noexcept {
  const Piece& only = plan_.pieces[0];
  if (only.path != nullptr) return jerk_share(*only.path, from, to);
  if (only.chain != nullptr) return jerk_share(only.chain->moves[0], robot_, from, to);
  return jerk_share(*only.joints, robot_, from, to);
}

}  // namespace armature
