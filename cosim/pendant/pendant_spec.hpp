// [pendant] and [[pendant.step]] of a scenario, as the user wrote them.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "controller/base/axes.hpp"

namespace armature::cosim {

inline constexpr std::array<std::string_view, 2> kPendantProfileNames{"strict", "extended"};

enum class PendantAct : std::uint8_t { kSend, kWait, kJog, kMove, kDownload, kEstop, kReadMessage };

inline constexpr std::array<std::string_view, 3> kPendantPathNames{"joints", "line", "arc"};

inline constexpr double kWithinMs = 200, kDownloadWithinMs = 60'000;

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
  std::string file;                                    // kDownload: a program, relative to the scenario file
  std::string text;                                    // kDownload: the text of that file
  bool adds_job = false;                               // kDownload
  std::string message;                                 // kReadMessage: the text to wait for; empty: any
  std::string kind = "message";                        // kReadMessage: what the text is, of MessageKind
  std::string reply = "ok";                            // not kWait, kReadMessage: the expected status
  std::optional<double> within_ms;                     // none: kWithinMs, kDownloadWithinMs
  int line = 0;
};

struct PendantSpec {
  std::string profile = "strict";
  double lost_percent = 0;     // of the bytes, in each direction
  double flipped_percent = 0;  // of the bytes, in each direction: one bit is wrong
  std::vector<PendantStepSpec> steps;
};

// True when a step sends a program that the controller shall accept.
[[nodiscard]] inline bool sends_program(const PendantStepSpec& step) {
  return step.act == PendantAct::kDownload && step.reply == "ok";
}
[[nodiscard]] inline bool sends_program(const PendantSpec& pendant) {
  return std::ranges::any_of(pendant.steps, [](const PendantStepSpec& step) { return sends_program(step); });
}

// The files of the program that the steps send, one for each job. None if they send no program, or more than one.
[[nodiscard]] inline std::vector<std::string> files_of_sent_program(const PendantSpec& pendant) {
  std::vector<std::string> files;
  for (const PendantStepSpec& step : pendant.steps) {
    if (!sends_program(step)) continue;
    if (!files.empty() && !step.adds_job) return {};
    files.push_back(step.file);
  }
  return files;
}

}  // namespace armature::cosim
