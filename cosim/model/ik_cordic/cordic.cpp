#include "cosim/model/ik_cordic/cordic.hpp"

#include <cstddef>

namespace armature::cosim::model::ik {
namespace {

class Lane {
 public:
  Lane(std::int64_t x, std::int64_t y, int bits, Widths& widths)
      : x_{widths.keep(x, bits)}, y_{widths.keep(y, bits)}, bits_{bits}, widths_{widths} {}

  void negate() { set(-x_, -y_); }
  void step(int i, bool clockwise) {
    const std::int64_t dx = y_ >> i, dy = x_ >> i;  // truncated
    clockwise ? set(x_ + dx, y_ - dy) : set(x_ - dx, y_ + dy);
  }
  [[nodiscard]] std::int64_t x() const { return x_; }
  [[nodiscard]] std::int64_t y() const { return y_; }

 private:
  void set(std::int64_t x, std::int64_t y) {
    x_ = widths_.keep(x, bits_);
    y_ = widths_.keep(y, bits_);
  }

  std::int64_t x_, y_;
  int bits_;
  Widths& widths_;
};

// The vector of the main lane, shifted until its larger component fills the lane but for the growth of a pass.
Lane normalised(const Vector& main, Widths& widths) {
  std::int64_t x = widths.keep(main.x, kMainBits + 1), y = widths.keep(main.y, kMainBits + 1);
  for (const int shift : {32, 16, 8, 4, 2, 1}) {
    if (magnitude(x, y) >> (kMainBits - shift) == 0) {
      x <<= shift;
      y <<= shift;
    }
  }
  return {x, y, kWordBits, widths};
}

Lane with_guard_bits(const Vector& slave, Widths& widths) {
  return {slave.x << kGuardBits, slave.y << kGuardBits, kLaneBits, widths};
}

std::int64_t without_guard_bits(std::int64_t value) {
  return (value + (1 << (kGuardBits - 1))) >> kGuardBits;
}

// The steps of one slave, in the order of the main lane's.
struct Steps {
  bool half_turn = false;
  std::array<bool, kArctangents.size()> clockwise{};
};

void follow(const Steps& steps, std::span<Vector> slaves, Widths& widths) {
  for (Vector& slave : slaves) {
    Lane lane = with_guard_bits(slave, widths);
    if (steps.half_turn) lane.negate();
    for (std::size_t i = 0; i < steps.clockwise.size(); ++i) lane.step(static_cast<int>(i), steps.clockwise[i]);
    slave = {without_guard_bits(lane.x()), without_guard_bits(lane.y())};
  }
}

}  // namespace

std::int64_t vectoring(const Vector& main, int zero_below, std::int64_t otherwise, std::span<Vector> slaves,
                       Widths& widths, bool* was_zero) {
  const bool zero = magnitude(main.x, main.y) >> zero_below == 0;
  if (was_zero != nullptr) *was_zero = zero;
  if (zero) {
    rotation(otherwise, slaves, widths);
    return otherwise;
  }
  Lane lane = normalised(main, widths);
  Steps steps;
  steps.half_turn = lane.x() < 0;
  if (steps.half_turn) lane.negate();
  std::int64_t turned = steps.half_turn ? kHalfTurn : 0;
  for (std::size_t i = 0; i < steps.clockwise.size(); ++i) {
    const bool clockwise = lane.y() >= 0;
    lane.step(static_cast<int>(i), clockwise);
    turned += clockwise ? kArctangents[i] : -kArctangents[i];
    steps.clockwise[i] = clockwise;
  }
  follow(steps, slaves, widths);
  return angle(turned);
}

void rotation(std::int64_t by, std::span<Vector> slaves, Widths& widths) {
  Steps steps;
  // Beyond a quarter turn the iterations do not reach.
  steps.half_turn = by < -kHalfTurn / 2 || by >= kHalfTurn / 2;
  std::int64_t left = steps.half_turn ? angle(by + kHalfTurn) : by;
  for (std::size_t i = 0; i < steps.clockwise.size(); ++i) {
    const bool clockwise = left >= 0;
    left = angle(left - (clockwise ? kArctangents[i] : -kArctangents[i]));
    steps.clockwise[i] = clockwise;
  }
  follow(steps, slaves, widths);
}

}  // namespace armature::cosim::model::ik
