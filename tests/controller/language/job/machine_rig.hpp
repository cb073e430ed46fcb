// A machine with its jobs, on a port that records what it is sent.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "controller/language/job/execute/machine.hpp"
#include "controller/language/program/breakpoints.hpp"
#include "tests/controller/language/job/job_text.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature::test {

class RecordingPort final : public ProgramPort {
 public:
  [[nodiscard]] bool has_room() const noexcept override { return room > 0; }
  void send(const Command& command, ProgramPlace place) noexcept override {
    --room;
    sent.emplace_back(command, place);
    if (const auto* output = std::get_if<SetOutput>(&command)) outputs[output->pin] = output->level;
  }
  [[nodiscard]] bool stop() noexcept override {
    ++stops;
    return true;
  }
  [[nodiscard]] bool done() const noexcept override { return arrived; }
  [[nodiscard]] JointAngles joints() const noexcept override { return at; }
  [[nodiscard]] bool level(std::uint8_t pin, bool output) noexcept override {
    return output ? outputs[pin] : inputs[pin];
  }
  void pulse(std::uint8_t pin, Ticks duration) noexcept override { pulses.emplace_back(pin, duration); }
  [[nodiscard]] Ticks now() noexcept override { return time; }
  void note(const ProgramNote& note) noexcept override {
    if (note.kind == ProgramNote::Kind::kLine) {
      lines.push_back(job::Machine::line_of(note.place));
    } else {
      (note.kind == ProgramNote::Kind::kAlarm ? alarms : messages).emplace_back(note.text.view());
    }
  }

  void charge_inverses(std::int64_t count) noexcept override { inverses += count; }
  [[nodiscard]] bool breakpoint_at(ProgramPlace place) noexcept override { return breakpoints.contains(place); }

  template <class Kind>
  [[nodiscard]] const Kind& sent_as(std::size_t i) const {
    return std::get<Kind>(sent.at(i).first);
  }

  int room = 1'000'000;
  bool arrived = true;
  int stops = 0;
  JointAngles at{};
  Ticks time{};
  std::array<bool, 17> inputs{}, outputs{};
  std::vector<std::pair<Command, ProgramPlace>> sent;
  std::vector<std::pair<int, Ticks>> pulses;
  std::vector<std::uint32_t> lines;
  std::vector<std::string> messages, alarms;
  std::int64_t inverses = 0;
  Breakpoints breakpoints;
};

// The arm, by default an ABB IRB 120, has a tool that is 100 mm long.
struct MachineRig {
  using Progress = Program::Progress;

  RobotModel robot;
  Arm arm{robot};
  job::MachineSetup setup{.cell = {.robot = robot, .arm = arm, .flange_T_tool = {.position_mm = {0, 0, 100}}}};
  Jobs jobs;
  RecordingPort port;
  std::unique_ptr<job::Machine> machine;

  // Loads the jobs and starts the first one.
  explicit MachineRig(const std::vector<std::string>& texts, const RobotModel& model = irb120()) : robot{model} {
    for (const std::string& text : texts) EXPECT_TRUE(jobs.load(text)) << jobs.said.errors.front();
    EXPECT_TRUE(jobs.loader->link());
    begin();
  }
  explicit MachineRig(const std::string& text) : MachineRig{std::vector{text}} {}

  void begin() {
    machine = std::make_unique<job::Machine>(*jobs.memory, setup);
    machine->start();
  }

  // Until the machine waits, pauses or ends.
  Progress run(int most_steps = 100'000) {
    for (int i = 0; i < most_steps; ++i) {
      const Progress progress = machine->step(port);
      if (progress != Progress::kWorking) return progress;
    }
    return Progress::kWorking;
  }

  // The value of a global variable.
  double value(job::VariableType type, int number) {
    double value = -1.0;
    EXPECT_EQ(machine->variables().load({type, false, static_cast<double>(number)}, value), job::Alarm::kNone);
    return value;
  }
  double b(int number) { return value(job::VariableType::kB, number); }
  double i(int number) { return value(job::VariableType::kI, number); }
  double d(int number) { return value(job::VariableType::kD, number); }
  double r(int number) { return value(job::VariableType::kR, number); }
  const job::PositionValue& p(int number) {
    return *machine->variables().position({job::VariableType::kP, false, static_cast<double>(number)});
  }
};

// Executes instructions to the end; the rig shows what they did.
inline MachineRig executed(const std::string& instructions) {
  MachineRig rig{job_of(instructions)};
  EXPECT_EQ(rig.run(), Program::Progress::kEnded) << (rig.port.alarms.empty() ? "" : rig.port.alarms.front());
  return rig;
}

// The alarm that instructions end with.
inline std::string alarm_of(const std::string& instructions) {
  MachineRig rig{job_of(instructions)};
  EXPECT_EQ(rig.run(), Program::Progress::kAlarm);
  return rig.port.alarms.empty() ? "" : rig.port.alarms.front();
}

}  // namespace armature::test
