#include "controller/trajectory/check/kink_check.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/timebase.hpp"

namespace armature {

void KinkCheck::begin(const CartesianPlan& plan) noexcept {
  count_ = next_ = 0;
  // The first set-points of a plan that continues another one were checked with that one.
  add_kinks(plan.table, plan.continues);
  const auto end = kinks_.begin() + static_cast<std::ptrdiff_t>(count_);
  std::sort(kinks_.begin(), end);
  count_ = static_cast<std::size_t>(std::unique(kinks_.begin(), end) - kinks_.begin());
}

void KinkCheck::add_kinks(const TimeTable& table, bool in_window) noexcept {
  const std::int64_t first_tick = in_window ? kBefore + 1 : 0;
  // Of the acceleration, or of the jerk where that is limited.
  const auto law_after = [&](std::size_t i) {
    if (i + 1 >= table.size()) return 0.0;
    return table[i].jerk != 0.0 ? table[i].jerk : table.accel(i);
  };
  // A smooth window has a kink at every point of its law, and between them its jerk is constant: any difference over
  // ticks is a mean of these.
  const double least_share = in_window && table.is_smooth() ? kLeastKinkOfJerk : kLeastKink;
  double most = 0.0;
  for (std::size_t i = 0; i + 1 < table.size(); ++i) most = std::max(most, std::fabs(law_after(i)));
  double before = 0.0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double after = law_after(i);
    const auto tick = static_cast<std::int64_t>(table[i].t_s / kTickSeconds);
    if (std::fabs(after - before) > least_share * most && tick >= first_tick) kinks_[count_++] = tick;
    before = after;
  }
}

int KinkCheck::sample(const CartesianPlan& plan, std::int64_t tick, const JointAngles& joints,
                      PathCheck& check) noexcept {
  int inverses = 0;
  for (; next_ < count_ && kinks_[next_] - kBefore <= tick; ++next_) {
    inverses += sample_around(plan, kinks_[next_], joints, check);
  }
  return inverses;
}

void KinkCheck::skip_to(std::int64_t tick) noexcept {
  while (next_ < count_ && kinks_[next_] - kBefore < tick) ++next_;
}

int KinkCheck::sample_around(const CartesianPlan& plan, std::int64_t kink, const JointAngles& joints,
                             PathCheck& check) const {
  int inverses = 0;
  static_assert((kBefore + kAfter) * kParts + 1 == kPoints);
  std::array<JointAngles, kPoints> path;
  const JointAngles* previous = &joints;
  for (std::size_t j = 0; j < path.size(); ++j) {
    const double tick = static_cast<double>(kink - kBefore) + static_cast<double>(j) / kParts;
    const double end = static_cast<double>(plan.duration.value());
    if (tick <= 0.0) {
      path[j] = plan.start;
    } else {
      const FollowedTool followed = follow_tool(plan, arm_, std::min(tick, end) * kTickSeconds, *previous);
      inverses += followed.inverses;
      path[j] = followed.tracking.found ? followed.tracking.joints : *previous;
    }
    previous = &path[j];
    constexpr auto kTick = static_cast<std::size_t>(kParts);
    // Set-points at whole ticks are checked by PathCheck::add().
    if (j >= 3 * kTick && j % kTick != 0) {
      check.add_between(plan, tick, {path[j], path[j - kTick], path[j - 2 * kTick], path[j - 3 * kTick]});
    }
  }
  return inverses;
}

}  // namespace armature
