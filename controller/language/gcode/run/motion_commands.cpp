#include "controller/language/gcode/run/motion_commands.hpp"

#include <algorithm>
#include <cmath>

#include "controller/base/angle_units.hpp"
#include "controller/base/math.hpp"
#include "controller/base/overloaded.hpp"
#include "controller/base/rounding.hpp"
#include "controller/base/timebase.hpp"
#include "controller/language/gcode/canon/arc.hpp"

namespace armature::gcode {
namespace {

constexpr double kMaxDwell_s = 86'400.0;
constexpr double kNoLength_mm = 1e-6;
constexpr double kNoAngle_deg = 1e-9;
// Radii that differ by more are made equal by a line at the end of the arc.
constexpr double kEqualRadii_mm = 1e-6;

Eigen::Vector3d position_of(const Axes6& axes) noexcept {
  return {axes[0], axes[1], axes[2]};
}

bool same_position(const Axes6& a, const Axes6& b) noexcept {
  return (position_of(a) - position_of(b)).norm() < kNoLength_mm;
}

bool same_turn(const Axes6& a, const Axes6& b) noexcept {
  return std::fabs(a[3] - b[3]) + std::fabs(a[4] - b[4]) + std::fabs(a[5] - b[5]) < kNoAngle_deg;
}

// The tool points against Z of the frame, then A, B and C turn it.
Eigen::Matrix3d normal_rotation(const Axes6& machine) noexcept {
  Eigen::Matrix3d down = Eigen::Matrix3d::Zero();
  down.diagonal() = Eigen::Vector3d{1.0, -1.0, -1.0};
  return rotation_from_rpy(direction_rad(machine[3]), direction_rad(machine[4]), direction_rad(machine[5])) * down;
}

}  // namespace

std::string_view text_of(MotionProblem problem) noexcept {
  switch (problem) {
    case MotionProblem::kNoSuchOutput:
      return "the tool has the outputs 0 to 15";
    case MotionProblem::kNoSuchAnalogOutput:
      return "the analog output is not defined";
    case MotionProblem::kDwellTooLong:
      return "a dwell lasts at most 24 h";
    case MotionProblem::kTurnNotAllowed:
      return "A, B and C need the orientation 'normal'";
  }
  return "";
}

void MotionCommands::begin(const Axes6& machine) noexcept {
  offsets_ = {};
  machine_ = machine;
  plane_ = Plane::kXy;
  control_ = {};
  feed_mm_s_ = feed_deg_s_ = 0.0;
  pending_mask_ = pending_levels_ = 0;
  count_ = 0;
}

std::optional<MotionProblem> MotionCommands::convert(const CanonCall& call) noexcept {
  count_ = 0;
  const auto none = [] { return Problem{}; };
  return std::visit(
      Overloaded{[&](const SetG5xOffset& c) {
                   offsets_.g5x = c.offset;
                   return none();
                 },
                 [&](const SetG92Offset& c) {
                   offsets_.g92 = c.offset;
                   return none();
                 },
                 [&](const SetXyRotation& c) {
                   offsets_.rotation_deg = c.deg;
                   return none();
                 },
                 [&](const UseToolLengthOffset& c) {
                   offsets_.tool = c.offset;
                   return none();
                 },
                 [&](const SelectPlane& c) {
                   plane_ = c.plane;
                   return none();
                 },
                 [&](const SetFeedRate& c) {
                   feed_mm_s_ = c.mm_min / 60.0;
                   feed_deg_s_ = c.number / 60.0;
                   return none();
                 },
                 [&](const SetMotionControlMode& c) {
                   control_ = c;
                   return none();
                 },
                 [&](const StraightTraverse& c) { return line(c.end, true); },
                 [&](const StraightFeed& c) { return line(c.end, false); }, [&](const ArcFeed& c) { return arc(c); },
                 [&](const Dwell& c) { return dwell(c.seconds); },
                 [&](const SetDigitalOutput& c) { return set_digital(c); },
                 [&](const SetAnalogOutput& c) { return set_analog(c); },
                 [&](const StartSpindle&) {
                   set_pin(setup_.settings.spindle_pin, true);
                   return none();
                 },
                 [&](const StopSpindle&) {
                   set_pin(setup_.settings.spindle_pin, false);
                   return none();
                 },
                 [&](const Mist& c) {
                   set_pin(setup_.settings.mist_pin, c.on);
                   return none();
                 },
                 [&](const Flood& c) {
                   set_pin(setup_.settings.flood_pin, c.on);
                   return none();
                 },
                 [&](const auto&) { return none(); }},
      call);
}

void MotionCommands::set_pin(std::uint8_t pin, bool on) noexcept {
  if (pin != 0) add(SetOutput{.pin = pin, .level = on});
}

std::optional<MotionProblem> MotionCommands::set_digital(const SetDigitalOutput& call) noexcept {
  if (call.index >= kPins) return MotionProblem::kNoSuchOutput;
  const std::uint32_t bit = 1U << static_cast<unsigned>(call.index);
  if (!call.with_motion) {
    pending_mask_ &= ~bit;
    set_pin(static_cast<std::uint8_t>(call.index + 1), call.on);
    return std::nullopt;
  }
  pending_mask_ |= bit;
  pending_levels_ = call.on ? pending_levels_ | bit : pending_levels_ & ~bit;
  return std::nullopt;
}

std::optional<MotionProblem> MotionCommands::set_analog(const SetAnalogOutput& call) noexcept {
  const auto index = static_cast<std::size_t>(call.index);
  const auto& all = setup_.settings.analog;
  if (index >= all.size() || all[index].first_pin == 0) return MotionProblem::kNoSuchAnalogOutput;
  const AnalogPins& pins = all[index];
  const double max_level = static_cast<double>((1U << pins.bits) - 1U);
  const auto level =
      static_cast<std::uint32_t>(round_half_away(std::clamp(call.value / pins.full, 0.0, 1.0) * max_level));
  for (std::uint32_t bit = 0; bit < pins.bits; ++bit) {
    const SetDigitalOutput one{.with_motion = call.with_motion,
                               .index = pins.first_pin - 1 + static_cast<int>(bit),
                               .on = (level >> bit & 1U) != 0};
    if (const Problem problem = set_digital(one)) return problem;
  }
  return std::nullopt;
}

std::optional<MotionProblem> MotionCommands::dwell(double seconds) noexcept {
  if (seconds > kMaxDwell_s) return MotionProblem::kDwellTooLong;
  const Ticks ticks{round_half_away(seconds / kTickSeconds)};
  if (ticks > Ticks{}) add(armature::Dwell{.duration = ticks});
  return std::nullopt;
}

std::optional<MotionProblem> MotionCommands::line(const Axes6& place, bool rapid) noexcept {
  const Axes6 machine = offsets_.machine(place);
  if (!same_turn(machine, machine_) && setup_.settings.orientation != MotionSettings::Orientation::kNormal) {
    return MotionProblem::kTurnNotAllowed;
  }
  add_line(machine, rapid);
  return std::nullopt;
}

void MotionCommands::add_line(const Axes6& machine, bool rapid) noexcept {
  if (!same_position(machine, machine_) || !same_turn(machine, machine_)) add_move(move_to(machine, rapid));
  machine_ = machine;
}

std::optional<MotionProblem> MotionCommands::arc(const ArcFeed& call) noexcept {
  const PlaneAxes axes = axes_of(plane_);
  const Axes6 start = offsets_.place(machine_);
  Axes6 end = start;
  end[axes.first] = call.first_end;
  end[axes.second] = call.second_end;
  end[axes.normal] = call.axis_end;
  end[3] = call.a;
  end[4] = call.b;
  end[5] = call.c;
  Axes6 centre = start;
  centre[axes.first] = call.first_axis;
  centre[axes.second] = call.second_axis;
  Axes6 above = centre;
  above[axes.normal] += 1.0;
  const Axes6 machine = offsets_.machine(end);
  if (!same_turn(machine, machine_) && setup_.settings.orientation != MotionSettings::Orientation::kNormal) {
    return MotionProblem::kTurnNotAllowed;
  }

  const PlanePoint from{start[axes.first], start[axes.second]};
  const PlanePoint to{call.first_end, call.second_end};
  const PlanePoint about{call.first_axis, call.second_axis};
  const bool clockwise = call.rotation < 0;
  const double angle = arc_angle(from, to, about, clockwise, clockwise ? -call.rotation : call.rotation);
  CartesianMove move = move_to(machine, false);
  move.kind = SegmentRequest::Kind::kArcAbout;
  move.via_mm = position_of(offsets_.machine(centre));
  move.about = {.axis = position_of(offsets_.machine(above)) - move.via_mm,
                .angle_rad = clockwise ? -angle : angle,
                .advance_mm = end[axes.normal] - start[axes.normal]};
  const double difference = std::fabs(math::hypot(from.first - about.first, from.second - about.second) -
                                      math::hypot(to.first - about.first, to.second - about.second));
  const bool spiral = difference > kEqualRadii_mm;
  add_move(move);
  machine_ = machine;
  if (spiral) add_move(move_to(machine, false));
  return std::nullopt;
}

CartesianMove MotionCommands::move_to(const Axes6& machine, bool rapid) const noexcept {
  using Mode = SetMotionControlMode::Mode;
  using Orientation = MotionSettings::Orientation;
  const MotionSettings& settings = setup_.settings;
  CartesianMove move;
  move.target.frame = settings.frame;
  move.target.position_mm = position_of(machine);
  if (settings.orientation == Orientation::kNormal) move.target.rotation = normal_rotation(machine);
  if (settings.orientation == Orientation::kTangent) move.orientation = CartesianMove::Orientation::kTangent;
  const bool turns_only = same_position(machine, machine_);
  move.limits = {.speed_mm_s = rapid || turns_only ? settings.rapid_mm_s : feed_mm_s_,
                 .accel_mm_s2 = settings.accel_mm_s2,
                 .turn_speed_rad_s = !rapid && turns_only ? feed_deg_s_ * kRadPerDeg : settings.rapid_turn_rad_s,
                 .turn_accel_rad_s2 = settings.turn_accel_rad_s2};
  move.exact_stop = control_.mode == Mode::kExactStop;
  move.rapid = rapid;
  if (control_.mode == Mode::kContinuous) {
    move.blend_mm = control_.tolerance_mm > 0.0 ? control_.tolerance_mm : settings.corner_mm;
  }
  return move;
}

// With the outputs that change at its start.
void MotionCommands::add_move(CartesianMove move) noexcept {
  for (std::uint8_t i = 0; i < kPins; ++i) {
    if ((pending_mask_ >> i & 1U) == 0) continue;
    const auto pin = static_cast<std::uint8_t>(i + 1);
    const bool level = (pending_levels_ >> i & 1U) != 0;
    if (move.outputs.count == PathOutputs::kMax) {
      set_pin(pin, level);
    } else {
      move.outputs.list[move.outputs.count++] = {
          .pin = pin, .level = level, .from = PathOutput::From::kStart, .unit = PathOutput::Unit::kMm, .offset = 0.0};
    }
  }
  pending_mask_ = 0;
  add(move);
}

}  // namespace armature::gcode
