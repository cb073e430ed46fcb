#include "controller/app/controller.hpp"

#include "controller/motion/motion_loop.hpp"

namespace armature {

Controller::Controller(const RobotModel& robot, const ControllerConfig& config, ControllerObserver& observer) noexcept
    : robot_{robot},
      config_{config},
      observer_{observer},
      dispatcher_{robot, config.sync, inbox_, mailbox_, observer} {}

void Controller::core0_main(RegisterBus& bus) noexcept {
  MotionLoop loop{robot_, config_.feedback, bus, mailbox_, observer_};
  loop.run();
}

void Controller::core1_main(RegisterBus& bus) noexcept {
  dispatcher_.run(bus);
}

bool Controller::submit(const Command& command) noexcept {
  return inbox_.try_push(command);
}

}  // namespace armature
