// The ticks of the logic, measured with the clock of the core: whether the logic stood still, and whether its tick is
// as long as it should be. A flipped bit of the timer would make the arm follow its path slower or faster.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/base/timebase.hpp"
#include "controller/base/units.hpp"

namespace armature {

class TickTime {
 public:
  // Before the first tick.
  void start(Cycles now) noexcept { woke_ = now; }

  // A tick begins: the core has waited for its trigger from `waits_since` to `now`.
  void wake(Cycles waits_since, Cycles now) noexcept {
    waited_ = now - waits_since;
    since_wake_ = now - woke_;
    woke_ = now;
  }

  // `missed`: the triggers without a commit since the tick before; none: the logic does not count them.
  void observe(std::optional<std::uint32_t> missed) noexcept {
    stood_still_ = waited_ > kLongestWait ||
                   (missed && since_wake_ > kLongestTick + Cycles{kTickCycles.value() * std::int64_t{*missed}});
    if (!missed || *missed != 0 || stood_still_) {
      ticks_.reset();
    } else if (ticks_) {
      ++*ticks_;
    }
    if (waited_ == Cycles{0}) return;  // the core was late, and does not know when the trigger came
    if (!ticks_) {
      begin_measurement();
    } else if (*ticks_ >= kMeasured) {
      const Cycles off = woke_ - measured_since_ - Cycles{kTickCycles.value() * *ticks_};
      wrong_ = off > kMostOff || off < -kMostOff;
      begin_measurement();
    }
  }

  // The core waited for the trigger, or more time has passed, than the ticks that the logic has counted explain.
  [[nodiscard]] bool stood_still() const noexcept { return stood_still_; }
  // In the last measurement a tick was shorter or longer than it should be by more than 0.8 %.
  [[nodiscard]] bool wrong() const noexcept { return wrong_; }

 private:
  // The core waits at most a tick for a trigger.
  static constexpr Cycles kLongestWait{kTickCycles.value() * 3 / 2};
  // From tick to tick, besides the ticks that the logic counts as underruns: two, and what may vary.
  static constexpr Cycles kLongestTick{kTickCycles.value() * 5 / 2};
  static constexpr std::int64_t kMeasured = 64;               // ticks, at least
  static constexpr Cycles kMostOff{kTickCycles.value() / 2};  // of all of them; the interrupt varies by much less

  void begin_measurement() noexcept {
    ticks_ = 0;
    measured_since_ = woke_;
  }

  Cycles woke_{}, since_wake_{}, waited_{};
  bool stood_still_ = false, wrong_ = false;
  std::optional<std::int64_t> ticks_{};  // measured so far, none of them missed
  Cycles measured_since_{};
};

}  // namespace armature
