// What the corners of joint moves have in common: how near a move passes a point, and where it may begin.
#pragma once

#include <algorithm>
#include <cstdint>

#include "controller/base/timebase.hpp"
#include "controller/base/units.hpp"
#include "controller/trajectory/joint/joint_retarget.hpp"

namespace armature {

// The set-point of a move that is closest to something.
struct ClosestSetPoint {
  double distance = 0.0;
  std::int64_t tick = 0;
};

// `distance_of(joints)`. Compares kCompared set-points of the whole move, then so many between the two neighbours of
// the closest one, and so on. A closer one may be missed: the corner is then rounded less.
template <class Distance>
[[nodiscard]] ClosestSetPoint closest_set_point(const RetargetPlan& plan, Distance distance_of) {
  constexpr std::int64_t kCompared = 64;
  std::int64_t first = 0, last = plan.duration.value();
  ClosestSetPoint closest{distance_of(position(plan, 0.0)), 0};
  while (true) {
    const std::int64_t stride = (last - first) / kCompared + 1;
    for (std::int64_t tick = first; tick <= last; tick += stride) {
      const double distance = distance_of(position(plan, seconds(Ticks{tick})));
      if (distance < closest.distance) closest = {distance, tick};
    }
    if (stride == 1) return closest;
    first = std::max<std::int64_t>(closest.tick - stride, 0);
    last = std::min(closest.tick + stride, plan.duration.value());
  }
}

// The earliest tick from `early` on that fits, if all later ones fit too; otherwise one at which this changes. `late`
// counts as one that fits, without a trial.
class EarliestFit {
 public:
  EarliestFit(std::int64_t early, std::int64_t late) noexcept : early_{early}, late_{late} {}

  // Until done(), whether trial() fits is to be given to set().
  [[nodiscard]] bool done() const noexcept { return late_ - early_ <= (tried_early_ ? 1 : 0); }
  [[nodiscard]] std::int64_t trial() const noexcept { return tried_early_ ? early_ + (late_ - early_) / 2 : early_; }
  void set(bool fits) noexcept {
    (fits ? late_ : early_) = trial();
    tried_early_ = true;
    last_fits_ = fits;
  }

  [[nodiscard]] std::int64_t tick() const noexcept { return late_; }  // the result, when done()
  [[nodiscard]] bool was_last_trial() const noexcept { return last_fits_; }

 private:
  std::int64_t early_, late_;
  bool tried_early_ = false;
  bool last_fits_ = false;
};

}  // namespace armature
