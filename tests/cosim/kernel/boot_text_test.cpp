// A controller that cannot start: both cores sleep, and the run says why.
#include "cosim/kernel/boot_text.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>

#include "controller/app/controller.hpp"
#include "controller/host_memory/boot_memory.hpp"
#include "controller/host_memory/host_side.hpp"
#include "cosim/kernel/scenario_soc.hpp"
#include "cosim/kernel/simulation.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "tests/cosim/support/scenario_files.hpp"
#include "tests/support/silent_listener.hpp"

namespace armature::cosim {
namespace {

using host_memory::BootMemory;
using host_memory::BootProgram;
using host_memory::HostMemory;

// A bus that only sleeps.
class SleepingBus final : public RegisterBus {
 public:
  int sleeps = 0;

  std::uint32_t read32(RegAddr) noexcept override { return unexpected(); }
  void write32(RegAddr, std::uint32_t) noexcept override { unexpected(); }
  Interrupts wait_for_interrupt(Interrupts mask) noexcept override {
    EXPECT_EQ(mask, Interrupts::kNone);
    return ++sleeps < 3 ? Interrupts::kEvent : Interrupts::kNone;
  }
  void send_event() noexcept override { unexpected(); }
  Cycles now() noexcept override { return Cycles{unexpected()}; }
  void charge(Work, std::int64_t) noexcept override { unexpected(); }

 private:
  static std::uint32_t unexpected() noexcept {
    ADD_FAILURE();
    return 0;
  }
};

std::string text_after(const std::function<void(HostMemory&)>& change, const BootProgram& program = {}) {
  BootMemory boot{RobotModel{}, ControllerConfig{}, program};
  change(boot.memory());
  const auto controller = std::make_unique<Controller>(boot.memory());
  SleepingBus bus;
  controller->core0_main(bus);
  controller->core1_main(bus);
  EXPECT_GE(bus.sleeps, 4);
  const host_memory::BootReport* report = host_memory::HostSide{boot.memory()}.boot_problem();
  if (report == nullptr) return {};
  const std::string text = boot_text(*report), begin = "the controller has not started: ";
  EXPECT_EQ(text.substr(0, begin.size()), begin);
  return text.substr(begin.size());
}

TEST(BootText, NamesTheBlockAndTheValue) {
  EXPECT_EQ(text_after([](HostMemory& memory) { ++memory.layout; }),
            "it was built for another layout of the host memory");
  RobotModel robot;
  robot.axes[2].gear_ratio = 0.0;
  EXPECT_EQ(text_after([&](HostMemory& memory) { host_memory::put(memory.robot.data(), 0, robot); }),
            "the value of robot.axes[2].gear_ratio is not allowed");
  EXPECT_EQ(text_after([](HostMemory& memory) { memory.config[1] = 2; }),
            "the value of config.feedback is not allowed");
  EXPECT_EQ(text_after([](HostMemory& memory) { memory.program[0] = 1; }), "the value of program.count is not allowed");
}

TEST(BootText, SaysWhereTheProgramIsWrong) {
  const BootProgram program{ProgramLanguage::kJob,
                            {{.name = "a.jbi", .text = "/JOB\n//NAME A\n//POS\n///NPOS 0,0,0,0,0,0\n//INST\nNOPE\n"}}};
  EXPECT_EQ(text_after([](HostMemory&) {}, program),
            "its program does not load: a.jbi:6:1: unknown instruction 'NOPE'");
}

TEST(BootText, ARunFailsAtOnce) {
  Scenario scenario = load_scenario(test::kScenarios / "fig9_joint_move", test::shipped());
  scenario.robot.axes[2].gear_ratio = 0.0;
  test::SilentListener listener;
  const SimulationEnd end = test::run_to_end(Simulation{scenario, make_soc(scenario), listener});
  EXPECT_EQ(end.reason, EndReason::kFailed);
  EXPECT_EQ(end.failure, "the controller has not started: the value of robot.axes[2].gear_ratio is not allowed");
  EXPECT_EQ(end.bus_reads + end.bus_writes, 0);
}

}  // namespace
}  // namespace armature::cosim
