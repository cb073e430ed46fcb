// What happens in a run, as its measurements keep it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "controller/message/event.hpp"
#include "cosim/bus/bus_error.hpp"
#include "cosim/report/measure/run_place.hpp"

namespace armature::cosim {

// The controller enters Fault. The axis is 0 when no single axis is the cause.
struct FaultEvent {
  FaultCause cause = FaultCause::kNone;
  RunPlace where{};
};

// An event that the facts do not know.
struct OtherEvent {
  Event event;
  Cycles at{};
};

struct RefusedMove {
  MoveRefused refusal;
  Cycles at{};
};

// A jog, from rest to rest.
struct JogRun {
  JogStarted started;
  std::optional<JogEnded> ended{};  // none: it is under way
};

// The homing of an axis.
struct HomingRun {
  HomingStarted started;
  std::optional<HomingEnded> ended{};  // none: it is under way
};

// What the program reports, but kWaits, kWaited and kOver.
struct ProgramEvent {
  ProgramNoted note;
  Cycles at{};
};

// An output of the tool changes its level.
struct OutputChange {
  int pin = 1;  // 1..16
  bool level = false;
  Cycles at{};
  // The tool centre point of the set-points at that time, in the base frame. None: not measured, or not expected.
  std::optional<Eigen::Vector3d> tool_mm{};
  double tolerance_mm = 0;  // of an expected `tool_mm`
};

// A core got an error response from the bus and stopped.
struct BusAbortEvent {
  int core = 0;
  bool write = false;
  std::uint32_t address = 0;
  BusError error = BusError::kNone;
  RunPlace where{};
};

}  // namespace armature::cosim
