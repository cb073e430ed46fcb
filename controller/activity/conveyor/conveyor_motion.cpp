#include "controller/activity/conveyor/conveyor_motion.hpp"

#include <cmath>

#include "controller/activity/joint_steps.hpp"
#include "controller/base/timebase.hpp"

namespace armature {
namespace {

// A belt is slower than its largest speed; what is left serves to catch up with it.
constexpr double kCatchUp = 2.0;
constexpr double kFar_mm = 1e9;
constexpr double kSynchronised_mm = 1e-6;

}  // namespace

ConveyorMotion::ConveyorMotion(const RobotModel& robot, const Arm& arm, const ConveyorConfig& config,
                               const Transform& flange_T_tool, double limit_share) noexcept
    : robot_{robot},
      arm_{arm},
      config_{config},
      flange_T_tool_{flange_T_tool},
      tool_T_flange_{inverse(flange_T_tool)},
      limit_share_{limit_share},
      max_speed_rad_s_{speed_limits_rad_s(robot)} {}

void ConveyorMotion::begin(const PerAxis<Radians>& position, double frame_mm) noexcept {
  begin_moving(position, {.position = frame_mm});
}

void ConveyorMotion::begin_moving(const PerAxis<Radians>& position, const AxisState& frame) noexcept {
  follower_ = AxisFollower{ProfileKind::kTrapezoid,
                           {.speed = kCatchUp * config_.max_speed_mm_s, .accel = config_.accel_mm_s2},
                           {.least = -kFar_mm, .largest = kFar_mm},
                           frame.position};
  follower_.set_state(frame);
  frame_ = frame;
  start_dwell(Ticks{0});
  pose_ = arm_.forward(position) * flange_T_tool_;
  planned_mm_ = frame.position;
  released_ = false;
  deviation_mm_ = 0.0;
  position_ = previous_ = before_ = position;
  if (frame.velocity == 0.0) return;
  const double step_mm = frame.velocity * kTickSeconds;
  previous_ = arm_.track(base_T_flange(pose_, frame.position - step_mm), position).joints;
  before_ = arm_.track(base_T_flange(pose_, frame.position - 2.0 * step_mm), previous_).joints;
}

void ConveyorMotion::start(const CartesianPlan& plan, double planned_mm) noexcept {
  plan_ = &plan;
  duration_ = plan.duration;
  elapsed_ = Ticks{0};
  pose_.position_mm += (planned_mm - planned_mm_) * config_.direction;
  planned_mm_ = planned_mm;
}

void ConveyorMotion::start_dwell(Ticks duration) noexcept {
  plan_ = nullptr;
  duration_ = duration;
  elapsed_ = Ticks{0};
}

void ConveyorMotion::release() noexcept {
  leaving_ = follower_.stop();
  leaving_ticks_ = 0;
  released_ = true;
}

ConveyorMotion::Trouble ConveyorMotion::advance(const AxisState& belt) noexcept {
  if (released_) {
    frame_ = leaving_.at(seconds(Ticks{++leaving_ticks_}));
  } else {
    follower_.advance(belt);
    frame_ = follower_.state();
    deviation_mm_ = frame_.position - belt.position;
  }
  if (!path_done()) {
    elapsed_ += Ticks{1};
    if (plan_ != nullptr) pose_ = tool_pose(*plan_, seconds(elapsed_));
  }
  const IkTracking found = arm_.track(base_T_flange(pose_, frame_.position), position_);
  if (!found.found || !solved(found.status)) return {.any = true, .axis = found.axis};
  const JointSteps steps{.previous = previous_, .position = position_, .next = found.joints};
  const std::uint8_t axis = axis_beyond_limits(robot_, max_speed_rad_s_, steps, limit_share_);
  if (axis != 0) return {.any = true, .axis = axis};
  before_ = previous_;
  previous_ = position_;
  position_ = found.joints;
  return {};
}

PerAxis<AxisState> ConveyorMotion::state() const noexcept {
  return make_per_axis([&](std::size_t axis) {
    return state_after(position_[axis].value(), previous_[axis].value(), before_[axis].value(), kTickSeconds);
  });
}

bool ConveyorMotion::synchronised() const noexcept {
  return std::fabs(deviation_mm_) <= kSynchronised_mm;
}

Transform ConveyorMotion::base_T_flange(const Transform& planned_T_tool, double frame_mm) const noexcept {
  Transform pose = planned_T_tool;
  pose.position_mm += (frame_mm - planned_mm_) * config_.direction;
  return pose * tool_T_flange_;
}

}  // namespace armature
