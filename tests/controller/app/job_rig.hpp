// A job of the robot language on the whole controller: the client of core 1, the dispatcher and the tick.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "controller/language/job/execute/machine.hpp"
#include "tests/controller/language/job/job_text.hpp"
#include "tests/controller/support/controller_rig.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature::test {

// Positions of axis 1 in pulses: C0 to C3. NOP is line 13.
inline std::string axis1_job(const std::string& instructions, const std::string& name = "TEST") {
  return "/JOB\n//NAME " + name +
         "\n//POS\n///NPOS 4,0,0,0,0,0\n///TOOL 0\n///POSTYPE PULSE\n///PULSE\n"
         "C00000=0,0,0,0,0,0\nC00001=10000,0,0,0,0,0\nC00002=20000,0,0,0,0,0\nC00003=30000,0,0,0,0,0\n//INST\n"
         "NOP\n" +
         instructions + "END\n";
}
inline constexpr std::uint32_t kLineOfNop = 13;

// The job begins at the first tick in which the arm stands.
struct JobRig : testing::Test {
  using State = ProgramClient::State;

  void start(const std::vector<std::string>& texts, std::optional<Ticks> begin = Ticks{0}) {
    host_memory::BootProgram program{.language = ProgramLanguage::kJob};
    for (const std::string& text : texts) program.files.push_back({.name = "a.jbi", .text = text});
    rig = std::make_unique<ControllerRig>(
        robot, ControllerConfig{.flange_T_tool = flange_T_tool, .program_start = begin}, program);
  }
  void start(const std::string& text, std::optional<Ticks> begin = Ticks{0}) { start(std::vector{text}, begin); }

  // An order of the operator.
  template <class Order>
  void at(std::int64_t tick, Order order) {
    rig->at(tick, [this, order] {
      order(rig->program());
      rig->wake_core1();
    });
  }
  // The output of a pin in each tick from now on.
  void watch(int pin) {
    rig->on_each_trigger = [this, pin] { levels.push_back((rig->logic.tool_outputs() >> (pin - 1) & 1U) != 0); };
  }
  [[nodiscard]] State state() const { return rig->program().state(); }
  [[nodiscard]] std::int64_t pulses() const { return rig->last().reference_pulses[0].value(); }
  // The lines that the moves came from, in the order in which they began.
  [[nodiscard]] std::vector<std::uint32_t> lines() const {
    std::vector<std::uint32_t> found;
    for (const MoveStarted& move : rig->moves) found.push_back(job::Machine::line_of(move.tag.number()) - kLineOfNop);
    return found;
  }
  // The tick in which core 1 switched the watched output on, and for how long it was on.
  [[nodiscard]] std::int64_t first_on() const { return std::ranges::find(levels, true) - levels.begin() - 1; }
  [[nodiscard]] std::int64_t ticks_on() const { return std::ranges::count(levels, true); }

  RobotModel robot = irb120();
  Arm arm{robot};
  Transform flange_T_tool{.position_mm = {0, 0, 100}};
  std::unique_ptr<ControllerRig> rig;
  std::vector<bool> levels;
};

}  // namespace armature::test
