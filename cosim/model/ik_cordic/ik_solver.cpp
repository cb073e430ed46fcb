#include "cosim/model/ik_cordic/ik_solver.hpp"

#include <algorithm>

#include "cosim/model/ik_cordic/cordic.hpp"
#include "cosim/model/ik_cordic/ik_words.hpp"

namespace armature::cosim::model::ik {
namespace {

// Clocks of a run, counted in rtl/ik_cordic/ik_program.sv: a part that each run has, and more for a shoulder whose
// squared distance is computed, and for one that reaches.
struct Clocks {
  int each, beyond, reached;
};
constexpr Clocks kClocksOfSix{199, 17, 521}, kClocksOfFive{275, 17, 213};

constexpr int kFarBits = 31;  // of a length below 64 units, with its sign: both links together are shorter

// The angles of flip - from those of flip +, in every branch.
void flip_all(Solved& solved) {
  const auto opposite = [](std::int32_t of, std::int64_t sign, std::int64_t turn) {
    return static_cast<std::int32_t>(angle(sign * of + turn));
  };
  for (std::size_t branch = 0; branch < kBranches; branch += 2) {
    const auto& plus = solved.theta[branch];
    solved.theta[branch + 1] = {plus[0],
                                plus[1],
                                plus[2],
                                opposite(plus[3], 1, kHalfTurn),
                                opposite(plus[4], -1, 0),
                                opposite(plus[5], 1, kHalfTurn)};
  }
}

class Solver {
 public:
  explicit Solver(const Job& job) : job_{job}, clocks_{job.five_r ? kClocksOfFive : kClocksOfSix} {}

  Solved solve() {
    find_wrist_centre();
    turn_to_the_plane();
    job_.five_r ? find_tool_of_five_r() : find_hand_of_six_r();
    find_squares();
    solve_shoulder(0);
    turn_to_the_back();
    solve_shoulder(1);
    flip_all(solved_);
    solved_.clocks += clocks_.each;
    solved_.exceeded = widths_.exceeded();
    return solved_;
  }

 private:
  // Index of a column of the rotation, and of the slave that carries its x and y.
  enum Column : std::size_t { kN, kO, kA, kWrist };

  [[nodiscard]] std::int64_t entry(Column column, std::size_t row) const { return job_.rotation[3 * column + row]; }
  [[nodiscard]] std::int64_t word(std::int64_t value) { return widths_.word(value); }
  [[nodiscard]] std::int64_t times(std::int64_t a, std::int64_t unit) { return widths_.product(a, unit, kUnitBits); }
  [[nodiscard]] std::int64_t square(std::int64_t a, std::int64_t b) { return widths_.product(a, b, kSquareShift); }

  void find_wrist_centre() {
    for (std::size_t row = 0; row < 3; ++row) {
      wrist_[row] = word(job_.position[row] - times(job_.hand, entry(kA, row)));
    }
  }

  // The direction of the vertical plane of the arm: of the wrist centre, or (kFiveR) of the tool point, and near axis 1
  // of the approach with the sign that points to the tool.
  [[nodiscard]] Vector heading() {
    if (!job_.five_r) return {wrist_[0], wrist_[1]};
    const Vector tool{job_.position[0], job_.position[1]}, approach{entry(kA, 0), entry(kA, 1)};
    const std::int64_t along = word(square(tool.x, approach.x) + square(tool.y, approach.y));
    const bool by_approach =
        magnitude(tool.x, tool.y) >> kNearAxis == 0 && magnitude(approach.x, approach.y) >> kNearAxis != 0;
    if (!by_approach) return tool;
    return along < 0 ? Vector{-approach.x, -approach.y} : approach;
  }

  // Turns columns and wrist centre by -theta_1: x is then outward in the plane, y across it.
  void turn_to_the_plane() {
    for (const Column column : {kN, kO, kA}) turned_[column] = {entry(column, 0), entry(column, 1)};
    turned_[kWrist] = {wrist_[0], wrist_[1]};
    theta1_ = vectoring(heading(), kZeroLength, job_.previous1, turned_, widths_, &solved_.shoulder_singular);
    outward_ = times(turned_[kWrist].x, kUngain);
    height_ = word(wrist_[2] - job_.base);
  }

  // Gains: rows 1 and 3 (outward, upward) G, row 2 (across) G^2, as after the rotation by theta_2 + theta_3.
  void find_hand_of_six_r() {
    for (const Column column : {kN, kO, kA}) {
      upward_[column] = times(entry(column, 2), kGain);
      across_[column] = word(-times(turned_[column].y, kGain));
    }
    outward_offset_ = word(-std::int64_t{job_.a1});
  }

  void find_tool_of_five_r() {
    const std::int64_t lean = times(turned_[kA].x, kUngain);
    outward_offset_ = word(times(job_.a4, entry(kA, 2)) - job_.a1);
    height_ = word(-height_);
    height_by_lean_ = times(job_.a4, lean);
    pitch_ = vectoring({word(-entry(kA, 2)), word(-lean)}, kZeroExact, 0, {}, widths_);
    theta5_ = vectoring({word(-turned_[kO].y), word(-turned_[kN].y)}, kZeroExact, 0, {}, widths_);
  }

  void find_squares() {
    const std::int64_t upper = job_.upper, fore = job_.fore;
    const std::int64_t longest = word(upper + fore), shortest = word(upper - fore);
    farthest2_ = square(longest, longest);
    nearest2_ = square(shortest, shortest);
    difference2_ = square(longest, shortest);
    sum2_ = word(square(upper, upper) + square(fore, fore));
  }

  void turn_to_the_back() {
    theta1_ = angle(theta1_ + kHalfTurn);
    theta5_ = angle(theta5_ + kHalfTurn);
    pitch_ = angle(-pitch_);
    outward_ = word(-outward_);
    height_by_lean_ = word(-height_by_lean_);
    for (const Column column : {kN, kO, kA}) {
      turned_[column].x = word(-turned_[column].x);
      across_[column] = word(-across_[column]);
    }
  }

  void solve_shoulder(int shoulder) {
    const std::int64_t x = word(outward_ + outward_offset_), y = word(height_ + height_by_lean_);
    if (low_bits(x, kFarBits) != x || low_bits(y, kFarBits) != y) return;
    const std::int64_t distance2 = word(square(x, x) + square(y, y));
    const std::int64_t to_outer = word(farthest2_ - distance2), to_inner = word(distance2 - nearest2_);
    const std::int64_t inside = std::min(to_outer, to_inner);
    if (inside < -kTolerance) {
      solved_.clocks += clocks_.beyond;
      return;
    }
    solved_.clocks += clocks_.reached;
    const auto mark = [shoulder](std::uint8_t& flags, bool is) {
      flags = static_cast<std::uint8_t>(flags | (is ? 1 : 0) << shoulder);
    };
    mark(solved_.clamped, inside < 0);
    mark(solved_.elbow_singular, inside < kTolerance);

    const std::int64_t area =
        widths_.root_of_product(std::max<std::int64_t>(to_outer, 0), std::max<std::int64_t>(to_inner, 0));
    bool folded = false;
    gamma_ = vectoring({x, y}, kZeroLength, job_.previous2, {}, widths_, &folded);
    mark(solved_.folded, folded);
    beta_ = vectoring({word(distance2 + difference2_), area}, kZeroExact, 0, {}, widths_);
    delta_ = vectoring({word(distance2 - sum2_), area}, kZeroExact, 0, {}, widths_);
    if (folded) beta_ = 0;
    if (job_.five_r) bend_the_other_way();
    for (const int elbow : {0, 1}) {
      solve_elbow(2 * shoulder + elbow);
      bend_the_other_way();
    }
  }

  void bend_the_other_way() {
    beta_ = angle(-beta_);
    delta_ = angle(-delta_);
  }

  void solve_elbow(int posture) {
    const std::int64_t theta2 = angle(gamma_ + beta_), theta3 = angle(job_.phi - delta_);
    if (job_.five_r) {
      set(posture, {theta1_, theta2, theta3, angle(angle(pitch_ - theta2) - theta3), theta5_, 0}, false);
      return;
    }
    // W = R03^T R: row 1 is x, row 3 is -y.
    std::array<Vector, 3> hand;
    for (const Column column : {kN, kO, kA}) hand[column] = {turned_[column].x, upward_[column]};
    rotation(angle(theta2 + theta3), hand, widths_);
    const std::int64_t w33 = word(-times(hand[kA].y, kGain));
    for (const Column column : {kN, kO, kA}) hand[column].y = across_[column];
    bool singular = false;
    const std::int64_t theta4 = vectoring(hand[kA], kZeroWrist, job_.previous4, hand, widths_, &singular);
    const std::int64_t theta5 = vectoring({w33, hand[kA].x}, kZeroExact, 0, {}, widths_);
    const std::int64_t theta6 = vectoring({hand[kO].y, hand[kN].y}, kZeroExact, 0, {}, widths_);
    set(posture, {theta1_, theta2, theta3, theta4, theta5, theta6}, !singular);
    if (singular) solved_.wrist_singular = static_cast<std::uint8_t>(solved_.wrist_singular | 1 << posture);
  }

  // Joints 4 to 6 have two solutions. A branch for flip +, and with `both` one for flip -.
  void set(int posture, const std::array<std::int64_t, kJoints>& theta, bool both) {
    auto& plus = solved_.theta[2 * static_cast<std::size_t>(posture)];
    for (std::size_t joint = 0; joint < kJoints; ++joint) plus[joint] = static_cast<std::int32_t>(theta[joint]);
    solved_.valid = static_cast<std::uint8_t>(solved_.valid | (both ? 3 : 1) << 2 * posture);
  }

  const Job& job_;
  Clocks clocks_;
  Widths widths_;
  Solved solved_;

  std::array<std::int64_t, 3> wrist_{};  // centre, in the base
  std::array<Vector, 4> turned_{};       // by Column
  std::int64_t theta1_ = 0, outward_ = 0, outward_offset_ = 0, height_ = 0, height_by_lean_ = 0;
  std::array<std::int64_t, 3> upward_{}, across_{};  // kSixR: rows 3 and 2 of the rotation, by Column
  std::int64_t pitch_ = 0, theta5_ = 0;              // kFiveR
  std::int64_t farthest2_ = 0, nearest2_ = 0, difference2_ = 0, sum2_ = 0;
  std::int64_t gamma_ = 0, beta_ = 0, delta_ = 0;
};

}  // namespace

Solved solve(const Job& job) {
  return Solver{job}.solve();
}

Solved unsolved() {
  Solved solved;
  flip_all(solved);
  return solved;
}

}  // namespace armature::cosim::model::ik
