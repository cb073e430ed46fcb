// Set-points that are computed before their ticks, so that the ticks until then have time for other work.
//
// The sampler makes the same steps as without them, only earlier. What it is asked for takes effect as many ticks later
// as there are steps ahead.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/trajectory/run/sampler.hpp"

namespace armature {

class StepsAhead {
 public:
  static constexpr std::size_t kMost = 3;

  // The sampler after one of its ticks.
  struct Step {
    PerAxis<Radians> position{};
    double rate = 0.0;
    double elapsed = 0.0;  // ticks of the plan
    bool busy = false;
  };
  [[nodiscard]] static Step step_of(const Sampler& sampler) noexcept {
    return {sampler.position(), sampler.rate(), sampler.elapsed(), sampler.busy()};
  }

  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
  [[nodiscard]] bool full() const noexcept { return count_ == kMost; }
  void push(const Step& step) noexcept {
    assert(!full());
    steps_[(first_ + count_++) % kMost] = step;
  }
  // The oldest one; not when empty().
  [[nodiscard]] const Step& pop() noexcept {
    assert(!empty());
    const Step& step = steps_[first_];
    first_ = (first_ + 1) % kMost;
    --count_;
    return step;
  }
  void clear() noexcept { count_ = 0; }

 private:
  std::array<Step, kMost> steps_{};
  std::size_t first_ = 0, count_ = 0;
};

}  // namespace armature
