// One run of both cores of the controller on the model of the logic: what each tick of core 0 took, and what it did.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "controller/app/controller.hpp"
#include "controller/message/command.hpp"
#include "controller/message/event.hpp"
#include "controller/message/telemetry.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature::bench {

struct TickScript {
  RobotModel robot;
  Transform flange_T_tool{};
  std::vector<std::pair<std::size_t, Command>> commands;  // tick and command, in order
  std::size_t ticks = 0;
  std::vector<Command> program{};  // given as fast as there is room, from the tick of the last command on
  bool cold = false;               // other memory is read between any two ticks, more than the caches of a core hold
};

struct TickFacts {
  double ns = 0.0;
  MotionState state = MotionState::kIdle;
  double rate = 0.0;
};

struct TickRun {
  std::vector<TickFacts> ticks;
  std::vector<MoveStarted> moves;
};

// Throws std::logic_error when a move is refused or not finished, the controller is in Fault or a commit is missing.
[[nodiscard]] TickRun run(const TickScript& script);

// What of every tick is the bus, the clock and not the controller: the accesses of a tick without anything else.
[[nodiscard]] std::vector<double> bus_alone_ns(std::size_t ticks);

}  // namespace armature::bench
