// A jog on core 0: the arm follows the velocities of core 1 (velocity_source.hpp). It is over when no command wants
// motion and the last pulse is emitted. Its start and its end are reported as events.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/activity/activity_source.hpp"
#include "controller/activity/jog/velocity_input.hpp"
#include "controller/activity/jog/velocity_source.hpp"
#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/message/event.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class JogSource final : public ActivitySource {
 public:
  // References must outlive the source.
  JogSource(const RobotModel& robot, const Arm& arm, const Transform& flange_T_tool, EventListener& events) noexcept;

  // ActivitySource; the content of a request is a VelocityCommand.
  void begin(const Request& first, const PerAxis<Radians>& stand, Ticks tick) noexcept override;
  void feed(const Request& next) noexcept override { commands_.add(next.get<VelocityCommand>()); }
  void stop(StopKind how) noexcept override;
  SetPoint& advance(Ticks tick, const RunControl::View& control) noexcept override;
  [[nodiscard]] bool over() noexcept override { return still_ticks_ >= kTicksToEmit; }
  void reset_to(const PerAxis<Radians>& position) noexcept override { set_point_ = {.position = position}; }
  void cut_short(Ticks tick) noexcept override { report_end({.how = JogEnd::kFault}, tick); }

 private:
  // The strongest command since the last tick.
  class Commands final : public VelocityInput {
   public:
    void clear() noexcept;
    void add(const VelocityCommand& command) noexcept;
    [[nodiscard]] std::uint32_t count() const noexcept { return count_; }  // since clear()
    [[nodiscard]] bool empty() const noexcept { return !latest_; }
    [[nodiscard]] std::optional<VelocityCommand> latest() noexcept override;

   private:
    std::optional<VelocityCommand> latest_{};
    std::uint32_t count_ = 0;
  };

  void report_end(VelocitySource::Ending ending, Ticks last) noexcept;

  EventListener& events_;
  Commands commands_;
  VelocitySource velocity_;
  int still_ticks_ = 0;  // ticks at rest without a command
  JogStarted started_{};
  Ticks last_step_{};  // the latest tick with motion
};

}  // namespace armature
