// Motion of one axis as a sequence of phases with constant jerk, from any state of motion.
//
// Any unit of length L: L/s, L/s^2, L/s^3.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <span>

namespace armature {

// Where an axis is and how it moves.
struct AxisState {
  double position = 0.0;
  double velocity = 0.0;
  double accel = 0.0;

  [[nodiscard]] bool at_rest() const noexcept { return velocity == 0.0 && accel == 0.0; }
};

// The state after `t_s` of constant jerk.
[[nodiscard]] AxisState after(const AxisState& state, double jerk, double t_s) noexcept;

// The state at the newest of three positions in intervals of `step_s`, whatever moved the axis: that with constant
// acceleration through all three. So the differences of positions across the change to another motion are those of one
// motion, and keep the limits that both keep.
[[nodiscard]] AxisState state_after(double newest, double previous, double oldest, double step_s) noexcept;

// A part of a motion with constant jerk.
struct Phase {
  double duration_s;
  double accel;  // at its start
  double jerk;
};

// Phases in their order. Without a jerk limit the acceleration may jump between them.
class Phases {
 public:
  static constexpr std::size_t kMax = 8;

  Phases() noexcept {}  // NOLINT: what has no phase is not set, because many of them are made in a tick

  // A phase that takes no time is left out. A negative duration is a rounding error and counts as none.
  void add(double duration_s, double accel, double jerk) noexcept {
    if (!(duration_s > 0.0)) return;
    assert(count_ < kMax);
    phases_[count_++] = {duration_s, accel, jerk};
  }
  [[nodiscard]] std::size_t size() const noexcept { return count_; }
  [[nodiscard]] const Phase& operator[](std::size_t index) const noexcept { return phases_[index]; }
  [[nodiscard]] const Phase* begin() const noexcept { return phases_.data(); }
  [[nodiscard]] const Phase* end() const noexcept { return phases_.data() + count_; }

  [[nodiscard]] double duration_s() const noexcept;
  // The state after all phases. They determine the acceleration; that of `state` counts only if there is none.
  [[nodiscard]] AxisState after_all(const AxisState& state) const noexcept;

 private:
  std::array<Phase, kMax> phases_;
  std::size_t count_ = 0;
};

// A motion that can be evaluated at any time. After its end it continues with the velocity that it has there.
class PhaseLaw {
 public:
  static constexpr std::size_t kMaxPhases = 14;

  // An axis that keeps the velocity of `start`, for no time.
  PhaseLaw() noexcept = default;
  explicit PhaseLaw(const AxisState& start) noexcept : end_{start.position, start.velocity, 0.0} {}
  // The same, without setting what has no phase.
  void restart(const AxisState& start) noexcept {
    count_ = 0;
    duration_s_ = 0.0;
    end_ = {start.position, start.velocity, 0.0};
  }

  void append(const Phase& phase) noexcept;
  // Sets the position and the velocity of the end, which differ from the sums over the phases by rounding.
  void set_end(double position, double velocity) noexcept { end_ = {position, velocity, 0.0}; }

  [[nodiscard]] double duration_s() const noexcept { return duration_s_; }
  [[nodiscard]] const AxisState& end() const noexcept { return end_; }
  // For t_s < 0 the state at 0; from the duration on that of the end. At a jump of the acceleration the value after it.
  [[nodiscard]] AxisState at(double t_s) const noexcept;

  // The least and the largest position from start to end.
  struct Extent {
    double least = 0.0;
    double largest = 0.0;
  };
  [[nodiscard]] Extent extent() const noexcept;
  // The largest speed from start to end.
  [[nodiscard]] double peak_speed() const noexcept;
  // The largest magnitude of the acceleration.
  [[nodiscard]] double peak_accel() const noexcept;

  // The start of each phase, in order.
  struct Knot {
    double start_s = 0.0;
    AxisState state{};
    double jerk = 0.0;
  };
  [[nodiscard]] std::span<const Knot> knots() const noexcept { return {knots_.data(), count_}; }

 private:
  [[nodiscard]] double length_s(std::size_t knot) const noexcept {
    return (knot + 1 < count_ ? knots_[knot + 1].start_s : duration_s_) - knots_[knot].start_s;
  }

  std::array<Knot, kMaxPhases> knots_{};
  std::size_t count_ = 0;
  double duration_s_ = 0.0;
  AxisState end_{};
};

}  // namespace armature
