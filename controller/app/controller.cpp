#include "controller/app/controller.hpp"

#include <type_traits>

#include "controller/motion/count_logic_port.hpp"
#include "controller/motion/motion_loop.hpp"

namespace armature {

// A core may lose its supply, or its simulation end, in any bus access: its stack is then dropped without a destructor
// being run. Whatever lives on it must own nothing.
static_assert(std::is_trivially_destructible_v<MotionLoop> && std::is_trivially_destructible_v<CountLogicPort> &&
              std::is_trivially_destructible_v<PaperLogicPort>);

Controller::Controller(const RobotModel& robot, const ControllerConfig& config, ControllerObserver& observer) noexcept
    : robot_{robot},
      paper_{config.paper},
      feedback_{config.feedback && !config.paper},
      planning_{.sync = config.sync,
                .flange_T_tool = config.flange_T_tool,
                .base_T_user = config.base_T_user,
                .max_stretch = config.max_stretch},
      arm_{robot},
      observer_{observer},
      dispatcher_{robot, arm_, planning_, inbox_, mailbox_, observer} {}

void Controller::core0_main(RegisterBus& bus) noexcept {
  const auto run_on = [&](LogicPort& logic) {
    MotionLoop{robot_, arm_, feedback_, logic, bus, mailbox_, observer_}.run();
  };
  if (paper_) {
    PaperLogicPort logic{bus, *paper_};
    run_on(logic);
  } else {
    CountLogicPort logic{bus};
    run_on(logic);
  }
}

void Controller::core1_main(RegisterBus& bus) noexcept {
  dispatcher_.run(bus);
}

bool Controller::submit(const Command& command) noexcept {
  return inbox_.try_push(command);
}

}  // namespace armature
