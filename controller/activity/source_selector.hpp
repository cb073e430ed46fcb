// The set-points of the controller: from the source whose activity has the arm.
//
// Plans have it by default. A kBegin gives it to another source, until that is over: then core 1 is told where the arm
// stands, as after a stop.
#pragma once

#include <array>

#include "controller/activity/channel.hpp"
#include "controller/activity/sources.hpp"
#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "controller/kinematics/arm.hpp"
#include "controller/message/event.hpp"
#include "controller/motion/logic_port.hpp"
#include "controller/motion/set_point_source.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class SourceSelector final : public SetPointSource {
 public:
  // References must outlive the selector. The arms: see Sources.
  SourceSelector(const RobotModel& robot, const Arm& path_arm, const Arm& arm, const Transform& flange_T_tool,
                 Channel& channel, EventListener& events, LogicPort& logic, const BeltParts& belt = {}) noexcept;
  SourceSelector(const SourceSelector&) = delete;
  SourceSelector& operator=(const SourceSelector&) = delete;

  // SetPointSource
  const SetPoint& advance(Ticks tick) noexcept override;
  void reset_to(const PerAxis<Radians>& position) noexcept override;
  void cut_short(Ticks tick) noexcept override;
  void cancel(Ticks tick) noexcept override;
  [[nodiscard]] Order take_order() noexcept override;

 private:
  [[nodiscard]] static bool is_order(const Request& request) noexcept {
    return request.kind == Request::Kind::kSwitchOff || request.kind == Request::Kind::kClearFault;
  }
  void read_requests(Ticks tick) noexcept;
  // False: the activity of a stop is over, so the arm stands.
  [[nodiscard]] bool give(const Request& request, Ticks tick) noexcept;
  void give_back_to_plans(const PerAxis<Radians>& position) noexcept;
  template <class Action>
  void for_each(Action action) noexcept {
    for (ActivitySource* source : sources_) {
      if (source != nullptr) action(*source);
    }
  }

  Channel& channel_;
  Sources own_;
  std::array<ActivitySource*, kActivities> sources_ = own_.all();
  ActivitySource* owner_ = &own_.plans;
  bool late_stop_ = false;  // a stop came too late: core 1 waits for the answer
};

}  // namespace armature
