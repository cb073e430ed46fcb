#include <fmt/format.h>

#include <iostream>

#include "cosim/cli/commands.hpp"
#include "cosim/cli/scenario_folder.hpp"
#include "cosim/scenario/robot_loader.hpp"
#include "cosim/scenario/scenario_loader.hpp"

namespace armature::cosim {

int list_command() {
  const auto folder = scenario_folder();
  int exit_code = kExitOk;
  for (const std::string& name : list_scenarios(folder)) {
    try {
      const Scenario scenario = load_scenario(folder / name, {.scenarios_dir = folder, .overrides = {}});
      std::cout << fmt::format("{:<24} {:<20} {:>5.2f} s  {}\n", name, scenario.robot_name, scenario.duration_s,
                               scenario.description);
    } catch (const InputError& error) {
      // The others are still worth listing.
      std::cout << fmt::format("{:<24} cannot be read\n", name);
      std::cerr << error.what() << '\n';
      exit_code = kExitBadInput;
    }
  }
  std::cout << "robots\n";
  for (const std::string& name : list_robots(folder / "robots")) {
    try {
      const RobotSpec robot = load_robot(folder / "robots" / (name + ".toml"));
      std::cout << fmt::format("{:<24} {:<20} {}\n", name,
                               robot.kinematics ? robot.kinematics->family : "joint moves only", robot.description);
    } catch (const InputError& error) {
      std::cout << fmt::format("{:<24} cannot be read\n", name);
      std::cerr << error.what() << '\n';
      exit_code = kExitBadInput;
    }
  }
  return exit_code;
}

}  // namespace armature::cosim
