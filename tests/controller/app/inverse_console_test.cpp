// The lines that the controller shows of a solved pose.
#include "controller/app/inverse_console.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "controller/app/controller.hpp"
#include "controller/base/angle_units.hpp"
#include "controller/host_memory/boot_memory.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

std::string angle_text(double deg) {
  IkSolutions solutions{.count = 1};
  solutions.branches[0].joints[0] = Radians{deg * kRadPerDeg};
  const auto line = InverseConsole::branch_line(solutions, 0, 1);
  const std::string text{line.view()};
  return text.substr(text.find('=') + 1, text.size() - text.find('=') - 3);
}

TEST(InverseConsole, AnglesHaveNineDecimals) {
  EXPECT_EQ(angle_text(0), "0.000000000");
  EXPECT_EQ(angle_text(-90), "-90.000000000");
  EXPECT_EQ(angle_text(12.3456789012), "12.345678901");
  EXPECT_EQ(angle_text(-0.0000000014), "-0.000000001");
  EXPECT_EQ(angle_text(-0.0000000004), "0.000000000");  // no minus without a digit
  EXPECT_EQ(angle_text(35'999.9999999996), "36000.000000000");
}

TEST(InverseConsole, ALineHasTheSidesAndTheJointsOfItsBranch) {
  IkSolutions solutions{.count = 2, .selected = 1, .status = IkStatus::kSingular};
  solutions.branches[1] = {.shoulder = -1, .elbow = 1, .flip = 0, .singular = kElbowSingular, .clamped = true};
  EXPECT_EQ(InverseConsole::first_line(solutions).view(), "solutions 2 status 2 selected 1\r\n");
  EXPECT_EQ(InverseConsole::branch_line(solutions, 1, 2).view(),
            "branch 1 shoulder -1 elbow 1 flip 0 singular 4 clamped 1 angle1=0.000000000 angle2=0.000000000\r\n");
}

TEST(InverseConsole, TheLongestLineIsNotCutOff) {
  IkSolutions solutions{.count = IkSolutions::kMax};
  IkBranch& branch = solutions.branches[7];
  branch = {.shoulder = -1, .elbow = -1, .flip = -1, .singular = 15, .clamped = true};
  branch.joints.fill(Radians{-36'000 * kRadPerDeg});
  EXPECT_TRUE(InverseConsole::branch_line(solutions, 7, kAxes).view().ends_with("angle6=-36000.000000000\r\n"));
}

// Reads as a UART whose FIFO is empty.
struct ConsoleBus final : RegisterBus {
  static constexpr std::size_t kMostWaits = 100;
  int accesses = 0;
  std::vector<Interrupts> waits;
  std::vector<Work> charges;
  std::string sent;

  std::uint32_t read32(RegAddr) noexcept override {
    ++accesses;
    return 0x60;
  }
  void write32(RegAddr addr, std::uint32_t value) noexcept override {
    ++accesses;
    const bool configured = accesses > 10;
    if (configured && addr == RegAddr{regs::soc::kAxiUart16550Base + 0x1000}) sent += static_cast<char>(value);
  }
  Interrupts wait_for_interrupt(Interrupts mask) noexcept override {
    waits.push_back(mask);
    return waits.size() < kMostWaits ? mask : Interrupts::kNone;  // which ends the core
  }
  void send_event() noexcept override {}
  Cycles now() noexcept override { return {}; }
  void charge(Work work, std::int64_t) noexcept override { charges.push_back(work); }
};

TEST(InverseConsole, InAControllerItIsAllThatHappens) {
  host_memory::BootMemory memory{test::irb120(),
                                 {.inverse = InverseTask{.base_T_flange = Transform{.position_mm = {5000, 0, 0}}}}};
  const auto controller = std::make_unique<Controller>(memory.memory());  // too large for a stack
  ConsoleBus core0, core1;
  controller->core0_main(core0);
  EXPECT_EQ(core0.accesses, 0);
  EXPECT_EQ(core0.waits, std::vector{Interrupts::kNone});
  controller->core1_main(core1);
  EXPECT_EQ(core1.charges, std::vector{Work::kInverse});
  EXPECT_EQ(core1.waits.back(), Interrupts::kNone);
  EXPECT_TRUE(core1.sent.ends_with("solutions 0 status 3 selected -1\r\nend\r\n")) << core1.sent;
}

}  // namespace
}  // namespace armature
