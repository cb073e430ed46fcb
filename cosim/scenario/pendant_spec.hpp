// [pendant] and [[pendant.step]] of a scenario, as the user wrote them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "controller/core/axes.hpp"

namespace armature::cosim {

inline constexpr std::array<std::string_view, 2> kPendantProfileNames{"strict", "extended"};

enum class PendantAct : std::uint8_t { kSend, kWait, kJog, kMove, kEstop };
inline constexpr std::array<std::string_view, 5> kPendantActNames{"send", "wait", "jog", "move", "estop"};

inline constexpr std::array<std::string_view, 3> kPendantPathNames{"joints", "line", "arc"};

struct PendantStepSpec {
  double at_s = 0;  // earliest; a step begins when the one before it is complete
  PendantAct act = PendantAct::kSend;
  std::string command;          // kSend: of the protocol
  std::int64_t parameter = 0;   // kSend
  std::int64_t payload = 0;     // kSend
  std::string state;            // kWait
  std::int64_t axis = 1;        // kJog: 1..6
  double percent = 0;           // kJog: of the speed of jogs
  double for_s = 0;             // kJog
  bool release = true;          // kJog: the key is released at the end; otherwise the pendant falls silent
  std::string path = "joints";  // kMove
  std::optional<PerAxis<double>> joints_deg;           // kMove, with joint coordinates
  std::optional<std::array<double, 3>> xyz_mm;         // kMove, with others
  std::array<double, 3> rpy_deg{};                     // kMove
  std::optional<std::array<double, 3>> via_mm;         // kMove, an arc
  std::optional<double> speed_percent, accel_percent;  // kMove
  std::string reply = "ok";                            // kSend, kMove, kJog: the expected status
  double within_ms = 200;
  int line = 0;
};

struct PendantSpec {
  std::string profile = "strict";
  double lost_percent = 0;     // of the bytes, in each direction
  double flipped_percent = 0;  // of the bytes, in each direction: one bit is wrong
  std::vector<PendantStepSpec> steps;
};

}  // namespace armature::cosim
