// How the machine moves the arm: joint moves, tags, tools, speeds and shifts.
#include <algorithm>

#include "controller/base/angle_units.hpp"
#include "controller/language/job/machine.hpp"

namespace armature::job {
namespace {

constexpr double kMostPl = 8.0;
// What one unit of a variable means for each tag.
constexpr double kVjUnit = 0.01, kVUnit = 0.1;

}  // namespace

bool Machine::move_target(std::size_t& at, PositionValue& target) noexcept {
  if (operand(at).kind == OperandKind::kPosition) {
    target = PositionValue::of(memory_.positions[static_cast<std::size_t>(operand(at).number)]);
    return ++at, true;
  }
  const PositionValue* position = position_variable(at);
  if (position == nullptr) return false;
  if (!position->set) return fail(Alarm::kNotSet);
  target = *position;
  return true;
}

// The target of another record of this job.
bool Machine::position_of(std::uint16_t at_record, PositionValue& target) noexcept {
  const std::span<const Operand> own = operands_;
  operands_ = memory_.operands_of(record(at_record));
  std::size_t at = 0;
  const bool read = move_target(at, target);
  operands_ = own;
  return read;
}

bool Machine::read_tags(std::size_t at, MoveTags& tags) noexcept {
  while (at < operands_.size()) {
    if (operand(at).kind != OperandKind::kTag) {
      skip(at);
      continue;
    }
    const auto tag = static_cast<TagName>(operand(at).what);
    const double unit = tag == TagName::kVj ? kVjUnit : tag == TagName::kV || tag == TagName::kVr ? kVUnit : 1.0;
    double value = 0.0;
    if (!tag_number(at, unit, value)) return false;
    switch (tag) {
      case TagName::kVj:
        tags.vj = value;
        break;
      case TagName::kV:
        tags.v = value;
        break;
      case TagName::kVr:
        tags.vr = value;
        break;
      case TagName::kPl:
        tags.pl = value;
        break;
      case TagName::kCr:
        tags.cr = value;
        break;
      case TagName::kAcc:
        tags.acc = value;
        break;
      case TagName::kDec:
        tags.dec = value;
        break;
      default:
        return fail(Alarm::kUnsupported);
    }
  }
  const auto outside = [](const std::optional<double>& tag, double least, double most) {
    return tag && !(*tag >= least && *tag <= most);
  };
  const bool wrong = outside(tags.vj, 0.01, 100.0) || outside(tags.v, 0.1, 30'000.0) ||
                     outside(tags.vr, 0.1, 1'000.0) || outside(tags.pl, 0.0, kMostPl) ||
                     outside(tags.cr, 0.0, 1'000.0) || outside(tags.acc, 1.0, 100.0) || outside(tags.dec, 1.0, 100.0);
  return !wrong || fail(Alarm::kRange);
}

// The share of the accelerations: the smaller one of ACC and DEC, because a plan has one for both.
double Machine::share_of_acceleration(const MoveTags& tags) noexcept {
  return std::min(tags.acc.value_or(100.0), tags.dec.value_or(100.0)) / 100.0;
}

// Where UNTIL stands in the operands of a move; behind them: nowhere.
std::size_t Machine::until_at() const noexcept {
  std::size_t at = 0;
  while (at < operands_.size() && !is_word(at, Word::kUntil)) ++at;
  return at;
}

bool Machine::input_reached(bool& reached) noexcept {
  std::size_t at = until_at() + 2;  // UNTIL IN#(
  double index = 0.0;
  if (!number(at, index)) return false;
  if (!(index >= 1.0 && index <= static_cast<double>(kPins))) return fail(Alarm::kPin);
  const bool wanted = is_word(at + 1, Word::kOn);
  reached = port_->level(static_cast<std::uint8_t>(index), false) == wanted;
  return true;
}

// The move was sent: the input ends it, or its end. The program goes on from where the arm stands then.
Machine::Outcome Machine::move_until() noexcept {
  bool reached = false;
  if (until_ == Until::kMoving) {
    if (!input_reached(reached)) return outcome_;
    if (reached && port_->stop()) until_ = Until::kStopping;
  }
  if (!port_->done()) {
    waits_for_time_ = true;
    return Outcome::kWait;
  }
  until_ = Until::kNone;
  planned_ = {};
  return Outcome::kNext;
}

Machine::Outcome Machine::move() noexcept {
  if (until_ != Until::kNone) return move_until();
  const bool until = until_at() < operands_.size();
  if (until) {
    bool reached = false;
    if (!wait_until_done() || !input_reached(reached)) return outcome_;
    if (reached) return Outcome::kNext;
  }
  const Outcome outcome = send_move();
  if (outcome != Outcome::kNext || !until) return outcome;
  until_ = Until::kMoving;
  waits_for_time_ = true;
  return Outcome::kWait;
}

Machine::Outcome Machine::send_move() noexcept {
  if (!port_->has_room()) return Outcome::kWait;
  std::size_t at = 0;
  PositionValue target;
  MoveTags tags;
  if (!move_target(at, target) || !read_tags(at, tags)) return outcome_;
  if (here().op == Op::kMovj) return move_joints(target, tags);
  if (!setup_.cell.arm.known()) return (void)fail(Alarm::kReach), outcome_;
  if (here().op == Op::kMovs && (here().flags & Record::kArcFirst) == 0) return move_on_spline();
  return move_path(target, tags);
}

Machine::Outcome Machine::move_joints(const PositionValue& target, const MoveTags& tags) noexcept {
  if (target.is_cartesian() && !(setup_.cell.arm.known() && use_tool(target.tool))) {
    if (setup_.cell.arm.known()) return outcome_;
    return (void)fail(Alarm::kReach), outcome_;
  }
  std::optional<JointAngles> joints;
  Transform base_T_tool;
  if (!target_of(target, joints, base_T_tool)) return outcome_;
  const double speed = tags.vj ? *tags.vj / 100.0 : joint_speed_;
  const double accel = share_of_acceleration(tags);
  const JointBlend blend{.share = tags.pl.value_or(0.0) / kMostPl};
  if (joints) {
    port_->send(JointMove{.target = *joints, .speed = speed, .accel = accel, .blend = blend}, place());
  } else {
    const FramedPose pose{.position_mm = base_T_tool.position_mm, .rotation = base_T_tool.rotation};
    port_->send(PoseMove{.target = pose, .speed = speed, .accel = accel, .blend = blend}, place());
  }
  planned_ = {.joints = joints};
  if (joints && setup_.cell.arm.known()) base_T_tool = tool_at(*joints);
  if (setup_.cell.arm.known()) planned_.base_T_tool = base_T_tool;
  return Outcome::kNext;
}

Machine::Outcome Machine::set_speeds() noexcept {
  MoveTags tags;
  if (!read_tags(0, tags)) return outcome_;
  if (tags.vj) joint_speed_ = *tags.vj / 100.0;
  if (tags.v) speed_mm_s_ = *tags.v;
  if (tags.vr) turn_speed_rad_s_ = *tags.vr * kRadPerDeg;
  return Outcome::kNext;
}

// SFTON: the shift is along the axes of a frame, and turns the tool about them.
Machine::Outcome Machine::set_shift() noexcept {
  std::size_t at = 0;
  const PositionValue* shift = position_variable(at);
  if (shift == nullptr) return outcome_;
  if (!shift->set) return (void)fail(Alarm::kNotSet), outcome_;
  if (!shift->is_cartesian()) return (void)fail(Alarm::kTypes), outcome_;
  const Transform by = pose_of(*shift);
  base_shift_.reset();
  tool_shift_.reset();
  shift_mm_.reset();
  if (is_word(at, Word::kToolFrame)) {
    tool_shift_ = by;
    return Outcome::kNext;
  }
  Transform base_T_frame;
  if (!frame_at(at, base_T_frame)) return outcome_;
  const Eigen::Matrix3d& r = base_T_frame.rotation;
  shift_mm_ = r * by.position_mm;
  base_shift_ = Transform{.rotation = r * by.rotation * r.transpose()};
  return Outcome::kNext;
}

}  // namespace armature::job
