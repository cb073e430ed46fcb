#include "cosim/campaign/draw_moves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

constexpr double kSpanDeg = 12;      // farthest way of an axis in a drawn move
constexpr double kPastIndexDeg = 1;  // to both sides of the start
constexpr double kFromLimitDeg = 2;  // drawn targets keep away from the limits
constexpr double kTurns = 2.1;       // of each motor in the last move
constexpr int kAngleDigits = 3;
constexpr double kSlow = 0.003;  // share of runs with a bus or inputs that the engine cannot compute in whole ticks

class Mover {
 public:
  Mover(Draw& draw, const RobotSpec& robot) : draw_{draw}, robot_{robot} {}

  [[nodiscard]] const PerAxis<double>& at() const { return at_; }

  void all_to(double deg) {
    for (std::size_t i = 0; i < robot_.axis_count; ++i) at_[i] = deg;
  }
  void step_somewhere() {
    for (std::size_t i = 0; i < robot_.axis_count; ++i) {
      if (draw_.chance(0.3)) continue;
      const AxisSpec& axis = robot_.axes[i];
      const double target = at_[i] + draw_.number(-kSpanDeg, kSpanDeg);
      at_[i] = std::clamp(target, axis.min_deg + kFromLimitDeg, axis.max_deg - kFromLimitDeg);
      at_[i] = std::stod(fixed_text(at_[i], kAngleDigits));
    }
  }
  void turn_all_motors() {
    for (std::size_t i = 0; i < robot_.axis_count; ++i) {
      const AxisSpec& axis = robot_.axes[i];
      const double way = kTurns * 360 / std::fabs(axis.gear_ratio);
      const bool up = axis.max_deg - at_[i] > at_[i] - axis.min_deg;
      at_[i] = std::stod(fixed_text(at_[i] + (up ? way : -way), kAngleDigits));
    }
  }
  // `10,20,30`, with zeros for axes that the robot does not have.
  [[nodiscard]] std::string place(std::size_t count) const {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += (i == 0 ? "" : ", ") + number_text(at_[i]);
    return text;
  }

 private:
  Draw& draw_;
  const RobotSpec& robot_;
  PerAxis<double> at_{};
};

std::string joint_table(Draw& draw, const RobotSpec& robot, const Mover& mover, bool full_speed) {
  std::string text = fmt::format("at_s = 0.01\ntype = \"joint\"\ntarget_deg = [{}]\n", mover.place(robot.axis_count));
  if (full_speed) return text;
  if (draw.chance(0.5)) text += fmt::format("speed_percent = {}\n", draw.integer(30, 100));
  if (draw.chance(0.3)) text += fmt::format("accel_percent = {}\n", draw.integer(50, 100));
  const bool has_jerk =
      std::ranges::all_of(robot.axes, [](const AxisSpec& axis) { return axis.max_jerk_deg_s3.has_value(); });
  if (has_jerk && draw.chance(0.25)) text += "profile = \"scurve\"\n";
  if (draw.chance(0.25)) text += fmt::format("blend_percent = {}\n", draw.integer(10, 100));
  return text;
}

std::string line_table(Draw& draw) {
  constexpr std::int64_t kMm = 25;
  return fmt::format(
      "at_s = 0.01\ntype = \"line\"\nxyz_mm = [{}, {}, {}]\nframe = \"tool\"\nspeed_mm_s = {}\naccel_mm_s2 = {}\n",
      draw.integer(-kMm, kMm), draw.integer(-kMm, kMm), draw.integer(-kMm, kMm), draw.integer(100, 400),
      draw.integer(2'000, 6'000));
}

std::string other_table(Draw& draw, const RobotSpec& robot) {
  const std::int64_t kind = draw.integer(0, robot.kinematics ? 3 : 1);
  if (kind == 0) return fmt::format("at_s = 0.01\ntype = \"dwell\"\nduration_s = 0.0{}\n", draw.integer(1, 2));
  if (kind == 1) {
    return fmt::format("at_s = 0.01\ntype = \"dout\"\npin = {}\nlevel = {}\n", draw.integer(1, 16), draw.integer(0, 1));
  }
  return line_table(draw);
}

void draw_tables(Draw& draw, const RobotSpec& robot, Mover& mover, CampaignCase& drawn) {
  for (const double deg : {kPastIndexDeg, -kPastIndexDeg}) {
    mover.all_to(deg);
    drawn.steps.push_back(joint_table(draw, robot, mover, true));
  }
  const std::int64_t count = draw.integer(0, 2);
  for (std::int64_t i = 0; i < count; ++i) {
    if (draw.chance(0.5)) {
      mover.step_somewhere();
      drawn.steps.push_back(joint_table(draw, robot, mover, false));
    } else {
      drawn.steps.push_back(other_table(draw, robot));
    }
  }
  mover.step_somewhere();
  drawn.steps.push_back(joint_table(draw, robot, mover, false));
  mover.turn_all_motors();
  drawn.steps.push_back(joint_table(draw, robot, mover, true));
  static_assert(kLastSteps == 1 && kFirstSteps == 2);
}

void draw_program(Draw& draw, Mover& mover, CampaignCase& drawn) {
  const auto move = [&] {
    drawn.steps.push_back(fmt::format("MOVJ C{} VJ=100.00", drawn.places.size()));
    drawn.places.push_back(mover.place(kAxes));
  };
  for (const double deg : {kPastIndexDeg, -kPastIndexDeg}) {
    mover.all_to(deg);
    move();
  }
  const std::int64_t count = draw.integer(0, 2);
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t kind = draw.integer(0, 3);
    if (kind == 0) {
      drawn.steps.emplace_back("TIMER T=0.01");
    } else if (kind == 1) {
      drawn.steps.push_back(fmt::format("DOUT OT#({}) ON", draw.integer(1, 16)));
    } else {
      mover.step_somewhere();
      move();
    }
  }
  mover.step_somewhere();
  move();
  mover.turn_all_motors();
  move();
}

}  // namespace

DrawnMoves draw_moves(Draw& draw, const std::vector<RobotSpec>& robots) {
  constexpr std::string_view kRelay = "drop_out_us = 500\n";
  const RobotSpec& robot = draw.one_of(robots);
  DrawnMoves moves;
  moves.drawn.robot = robot.name;
  moves.drawn.seed = draw.seed();
  moves.drawn.keys = kRelay;
  if (draw.chance(kSlow)) moves.drawn.keys += "input_jitter = true\n";
  Mover mover{draw, robot};
  if (robot.axis_count == kAxes && robot.kinematics && draw.chance(0.2)) {
    draw_program(draw, mover, moves.drawn);
  } else {
    if (draw.chance(kSlow)) moves.drawn.keys += "\n[bus]\nstall_probability = 0.2\n";
    draw_tables(draw, robot, mover, moves.drawn);
  }
  moves.end_deg = mover.at();
  return moves;
}

}  // namespace armature::cosim
