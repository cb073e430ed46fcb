// A port that keeps what a G-code program sends, and an arm with a frame for it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "controller/language/gcode/run/program_runner.hpp"
#include "controller/language/program/breakpoints.hpp"
#include "tests/controller/support/path_rig.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature::test {

struct Cell {
  Cell() {
    setup.cell.flange_T_tool.position_mm.z() = 100.0;
    setup.cell.base_T_user[0] = Transform{.position_mm = {350.0, 0.0, 200.0}};
    setup.settings.frame = FrameId{1};
  }
  Cell(const Cell&) = delete;
  Cell& operator=(const Cell&) = delete;

  RobotModel robot = [] {
    RobotModel model = paper_robot();
    model.arm = irb120().arm;
    return model;
  }();
  Arm arm{robot};
  gcode::MotionSetup setup{.cell = {.robot = robot, .arm = arm}};
  JointAngles joints = degrees({0.0, 20.0, 10.0, 0.0, 60.0, 0.0});

  [[nodiscard]] Transform user_T_tool() const {
    return inverse(*setup.cell.base_T_user[0]) * (arm.forward(joints) * setup.cell.flange_T_tool);
  }
};

class KeepingPort final : public ProgramPort {
 public:
  struct Sent {
    Command command;
    ProgramPlace place;
  };

  explicit KeepingPort(const Cell& cell) : cell_{cell} {}

  [[nodiscard]] bool has_room() const noexcept override { return sent.size() < room; }
  void send(const Command& command, ProgramPlace place) noexcept override { sent.push_back({command, place}); }
  [[nodiscard]] bool stop() noexcept override { return true; }
  [[nodiscard]] bool done() const noexcept override { return is_done; }
  [[nodiscard]] JointAngles joints() const noexcept override { return cell_.joints; }
  [[nodiscard]] bool level(std::uint8_t pin, bool output) noexcept override { return !output && inputs[pin]; }
  void pulse(std::uint8_t, Ticks) noexcept override {}
  [[nodiscard]] Ticks now() noexcept override { return time; }
  void note(const ProgramNote& note) noexcept override { notes.push_back(note); }
  void charge_inverses(std::int64_t count) noexcept override { inverses += count; }
  [[nodiscard]] bool breakpoint_at(ProgramPlace place) noexcept override { return breakpoints.contains(place); }

  // The sent commands of a kind.
  template <class Kind>
  [[nodiscard]] std::vector<Kind> all() const {
    std::vector<Kind> found;
    for (const Sent& one : sent) {
      if (const auto* command = std::get_if<Kind>(&one.command)) found.push_back(*command);
    }
    return found;
  }
  [[nodiscard]] std::vector<ProgramNote> notes_of(ProgramNote::Kind kind) const {
    std::vector<ProgramNote> found;
    for (const ProgramNote& note : notes) {
      if (note.kind == kind) found.push_back(note);
    }
    return found;
  }

  std::vector<Sent> sent;
  std::vector<ProgramNote> notes;
  std::int64_t inverses = 0;
  Breakpoints breakpoints;
  std::size_t room = 100'000;
  bool is_done = true;
  std::array<bool, 17> inputs{};
  Ticks time{};

 private:
  const Cell& cell_;
};

// Steps until the program ends, or does something else than to work.
inline Program::Progress run(gcode::ProgramRunner& runner, KeepingPort& port) {
  for (int i = 0; i < 1'000'000; ++i) {
    const Program::Progress progress = runner.step(port);
    if (progress != Program::Progress::kWorking) return progress;
  }
  return Program::Progress::kWorking;
}

}  // namespace armature::test
