#include "controller/trajectory/check/kink_check.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/timebase.hpp"

namespace armature {
namespace {

// The acceleration along a plan, or the jerk where that is limited: constant from one point of the table to the next.
class Law {
 public:
  explicit Law(const TimeTable& table) noexcept : table_{table} {}

  double after(std::size_t i) const noexcept {
    if (i + 1 >= table_.size()) return 0.0;
    return table_[i].jerk != 0.0 ? table_[i].jerk : table_.accel(i);
  }

  double largest() const noexcept {
    double most = 0.0;
    for (std::size_t i = 0; i + 1 < table_.size(); ++i) most = std::max(most, std::fabs(after(i)));
    return most;
  }

  // The largest difference from `before` within `longest_s` behind point `i`.
  double change(std::size_t i, double before, double longest_s) const noexcept {
    double most = 0.0;
    for (std::size_t j = i; j < table_.size() && table_[j].t_s <= table_[i].t_s + longest_s; ++j) {
      most = std::max(most, std::fabs(after(j) - before));
    }
    return most;
  }

  // Whether it is at least `least` anywhere from `before_s` before point `i` to `after_s` after it.
  bool reaches(double least, std::size_t i, double before_s, double after_s) const noexcept {
    const double from_s = table_[i].t_s - before_s, to_s = table_[i].t_s + after_s;
    for (std::size_t j = i; j > 0 && table_[j].t_s > from_s; --j) {
      if (std::fabs(after(j - 1)) >= least) return true;
    }
    for (std::size_t j = i; j < table_.size() && table_[j].t_s < to_s; ++j) {
      if (std::fabs(after(j)) >= least) return true;
    }
    return false;
  }

 private:
  const TimeTable& table_;
};

}  // namespace

void KinkCheck::begin(const CartesianPlan& plan) noexcept {
  count_ = next_ = 0;
  // The first set-points of a plan that continues another one were checked with that one.
  add_kinks(plan.table, plan.continues);
}

void KinkCheck::add_kinks(const TimeTable& table, bool in_window) noexcept {
  const std::int64_t first_tick = in_window ? kBefore + 1 : 0;
  const Law law{table};
  // A smooth window has a kink at every point of its law, and between them its jerk is constant: any difference over
  // ticks is a mean of these.
  const double least_share = in_window && table.is_smooth() ? kLeastKinkOfJerk : kLeastKink;
  // Core 1 has little time for a window: only single jumps count there, of the largest value of the window.
  const double longest_s = in_window ? 0.0 : kTickSeconds;
  const double most = law.largest();
  double before = 0.0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto tick = static_cast<std::int64_t>(table[i].t_s / kTickSeconds);
    const double size = law.change(i, before, longest_s);
    const double least = size / least_share;
    // The differences around the kink contain the law from kBefore ticks before it to kAfter ticks after it.
    const bool counts =
        tick >= first_tick && size > kLeastOfAll * most &&
        (in_window ? most < least : !law.reaches(least, i, kBefore * kTickSeconds, kAfter * kTickSeconds));
    if (counts && (count_ == 0 || kinks_[count_ - 1] != tick)) kinks_[count_++] = tick;
    before = law.after(i);
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
  std::array<ToolSample, kPoints> tool;
  const JointAngles* previous = &joints;
  for (std::size_t j = 0; j < path.size(); ++j) {
    const double tick = static_cast<double>(kink - kBefore) + static_cast<double>(j) / kParts;
    const double end = static_cast<double>(plan.duration.value());
    tool[j] = tool_sample(plan, std::clamp(tick, 0.0, end) * kTickSeconds);
    if (tick <= 0.0) {
      path[j] = plan.start;
    } else {
      const FollowedTool followed = follow_tool(plan, arm_, std::min(tick, end) * kTickSeconds, *previous);
      inverses += followed.inverses;
      path[j] = followed.tracking.found ? followed.tracking.joints : *previous;
      if (followed.on_bend) tool[j].rotation = held_tool_pose(plan, arm_, path[j]).rotation;
    }
    previous = &path[j];
    constexpr auto kTick = static_cast<std::size_t>(kParts);
    // Set-points at whole ticks are checked by PathCheck::add(), the tool half-way between them as well.
    if (j >= 3 * kTick && j % kTick != 0) {
      check.add_between(plan, tick, {path[j], path[j - kTick], path[j - 2 * kTick], path[j - 3 * kTick]});
    }
    if (j >= 2 * kTick && j % 2 != 0)
      check.add_tool_between(plan, tick, {tool[j], tool[j - kTick], tool[j - 2 * kTick]});
  }
  return inverses;
}

}  // namespace armature
