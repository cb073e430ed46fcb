#include "controller/activity/homing/axis_homing.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/timebase.hpp"
#include "controller/trajectory/joint/axis_limits.hpp"
#include "controller/trajectory/state/axis_reach.hpp"

namespace armature {
namespace {

// Longer than the range of the joint: limit switches are outside.
constexpr double kTravelShare = 1.25;

// The index must come within a revolution. An eighth is for the lag of the drive.
constexpr double kMaxRevolutionsToIndex = 1.125;

// An axis stands when its encoder has not moved by more than a count for this time: 20 ms, several time constants of a
// drive.
constexpr std::int64_t kStandTicks = 400;

constexpr double kRoundingTicks = 1e-6;

}  // namespace

AxisHoming::AxisHoming(const AxisModel& model) noexcept
    : model_{model.homing.value_or(HomingModel{})},
      units_{model},
      counts_per_rev_{model.counts_per_rev},
      travel_rad_{kTravelShare * (model.max_rad - model.min_rad)},
      limits_{axis_limits(model)} {}

void AxisHoming::begin(Radians position) noexcept {
  position_ = position;
  law_ = PhaseLaw{{.position = position.value()}};
  ticks_ = 0;
  phase_ = Phase::kFirst;
  how_ = HomingEnd::kStop;
  reached_switch_ = HomingSwitch::kNone;
  edge_to_index_ = shift_ = Counts{};
}

void AxisHoming::advance(const HomingSensors& sensors) noexcept {
  if (phase_ == Phase::kOver) return;
  react(sensors);
  ++ticks_;
  position_ = Radians{law_.at(seconds(Ticks{ticks_})).position};
}

void AxisHoming::react(const HomingSensors& sensors) noexcept {
  switch (phase_) {
    case Phase::kFirst:
      return start(sensors);
    case Phase::kSearch:
      return search(sensors);
    case Phase::kBackOff:
      return back_off(sensors);
    case Phase::kLeave:
      return leave(sensors);
    case Phase::kIndex:
      return find_index(sensors);
    case Phase::kHome:
      return go_home(sensors);
    case Phase::kBrake:
      if (law_over() && stands(sensors.position)) begin_phase(next_);
      return;
    case Phase::kOver:
      return;
  }
}

void AxisHoming::start(const HomingSensors& sensors) noexcept {
  if (sensors.home) reach(HomingSwitch::kOnHome);
  begin_phase(sensors.home ? Phase::kBackOff : Phase::kSearch);
}

void AxisHoming::search(const HomingSensors& sensors) noexcept {
  if (sensors.home) {
    reach(HomingSwitch::kHome);
    brake_before(Phase::kLeave);
  } else if (limit_ahead(sensors) && reached_switch_ == HomingSwitch::kNone) {
    reach(HomingSwitch::kLimit);
    brake_before(Phase::kBackOff);
  } else if (limit_ahead(sensors) || law_over()) {
    fail(HomingEnd::kNoSwitch);
  }
}

void AxisHoming::back_off(const HomingSensors& sensors) noexcept {
  if (left_switch(sensors)) {
    brake_before(Phase::kSearch);
  } else if (limit_ahead(sensors) || law_over()) {
    fail(on_switch_ ? HomingEnd::kSwitchStuck : HomingEnd::kNoSwitch);
  }
}

void AxisHoming::leave(const HomingSensors& sensors) noexcept {
  if (left_switch(sensors)) {
    edge_ = sensors.position;
    phase_ = Phase::kIndex;
  } else if (limit_ahead(sensors)) {
    fail(HomingEnd::kLimit);
  } else if (law_over()) {
    fail(HomingEnd::kSwitchStuck);
  }
}

void AxisHoming::find_index(const HomingSensors& sensors) noexcept {
  const std::int64_t away = (direction_ < 0.0) == (units_.rad_per_pulse() < 0.0) ? 1 : -1;  // sign of the counts
  const auto revolution = static_cast<double>(counts_per_rev_);
  const auto distance = [&](Counts from, Counts to) { return static_cast<double>(away * (to - from).value()); };
  // The index must be behind the edge, and the axis behind the index.
  if (sensors.index && distance(edge_, *sensors.index) >= 0.0 && distance(*sensors.index, sensors.position) >= 0.0) {
    const double share = distance(edge_, *sensors.index) / revolution;
    if (share < kEdgeMargin || share > 1.0 - kEdgeMargin) return fail(HomingEnd::kIndexAtEdge);
    edge_to_index_ = Counts{away * (*sensors.index - edge_).value()};
    shift_ = units_.to_counts(Radians{model_.index_rad}) - *sensors.index;
    phase_ = Phase::kHome;
    move_to(model_.home_rad - units_.to_radians(shift_).value(), model_.search_rad_s);
  } else if (limit_ahead(sensors)) {
    fail(HomingEnd::kLimit);
  } else if (law_over() || distance(edge_, sensors.position) > kMaxRevolutionsToIndex * revolution) {
    fail(HomingEnd::kNoIndex);
  }
}

void AxisHoming::go_home(const HomingSensors& sensors) noexcept {
  if (limit_ahead(sensors)) return fail(HomingEnd::kLimit);
  if (!law_over() || !stands(sensors.position)) return;
  how_ = HomingEnd::kHomed;
  phase_ = Phase::kOver;
}

void AxisHoming::reach(HomingSwitch what) noexcept {
  if (reached_switch_ == HomingSwitch::kNone) reached_switch_ = what;
}

void AxisHoming::begin_phase(Phase phase) noexcept {
  phase_ = phase;
  on_switch_ = false;
  if (phase == Phase::kSearch) move(model_.direction, model_.search_rad_s);
  if (phase == Phase::kBackOff) move(-model_.direction, model_.search_rad_s);
  if (phase == Phase::kLeave) move(-model_.direction, model_.latch_rad_s);
}

void AxisHoming::move(double direction, double speed) noexcept {
  move_to(position_.value() + direction * travel_rad_, speed);
}

void AxisHoming::move_to(double target, double speed) noexcept {
  TimeLawLimits limits = limits_;
  limits.speed = std::min(speed, limits_.speed);
  direction_ = target < position_.value() ? -1.0 : 1.0;
  law_ = plan_to_rest(ProfileKind::kTrapezoid, law_.at(seconds(Ticks{ticks_})), target, limits);
  ticks_ = 0;
  still_ticks_ = 0;
}

void AxisHoming::brake_before(Phase next) noexcept {
  law_ = plan_to_velocity(ProfileKind::kTrapezoid, law_.at(seconds(Ticks{ticks_})), 0.0, limits_);
  ticks_ = 0;
  still_ticks_ = 0;
  phase_ = Phase::kBrake;
  next_ = next;
}

void AxisHoming::fail(HomingEnd how) noexcept {
  how_ = how;
  brake_before(Phase::kOver);
}

void AxisHoming::stop() noexcept {
  if (phase_ == Phase::kOver || (phase_ == Phase::kBrake && next_ == Phase::kOver)) return;
  fail(HomingEnd::kStop);
}

bool AxisHoming::left_switch(const HomingSensors& sensors) noexcept {
  on_switch_ = on_switch_ || sensors.home;
  return on_switch_ && !sensors.home;
}

bool AxisHoming::limit_ahead(const HomingSensors& sensors) const noexcept {
  return direction_ > 0.0 ? sensors.limit_pos : sensors.limit_neg;
}

bool AxisHoming::law_over() const noexcept {
  return static_cast<double>(ticks_) + kRoundingTicks >= law_.duration_s() / kTickSeconds;
}

bool AxisHoming::stands(Counts measured) noexcept {
  const Counts moved = measured - still_at_;
  if (still_ticks_ == 0 || moved < Counts{-1} || moved > Counts{1}) {
    still_at_ = measured;
    still_ticks_ = 0;
  }
  return ++still_ticks_ > kStandTicks;
}

double AxisHoming::speed() const noexcept {
  return std::fabs(law_.at(seconds(Ticks{ticks_})).velocity);
}

}  // namespace armature
