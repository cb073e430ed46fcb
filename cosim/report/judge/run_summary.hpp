// A run with its measurements and verdicts: everything that the reports at its end show. cosim/run fills it in, and
// format/ writes it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "controller/base/units.hpp"
#include "cosim/golden/golden.hpp"
#include "cosim/logic/logic_spec.hpp"
#include "cosim/report/facts/fact.hpp"
#include "cosim/report/judge/expect_failure.hpp"
#include "cosim/report/judge/expect_result.hpp"
#include "cosim/report/judge/moment_wave.hpp"
#include "cosim/report/measure/run_facts.hpp"
#include "cosim/robot/robot_spec.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/text/input_file.hpp"
#include "cosim/text/names.hpp"

namespace armature::cosim {

struct RunSummary {
  // ---- the same on every machine
  std::string scenario;
  std::string description;
  std::string robot;
  std::string tool_version;                  // of this program
  std::vector<InputFile> sources;            // all files that the run was made from
  std::vector<std::string> overrides;        // `--set` of the command line, in their order
  RobotSpec arm;                             // of the robot, as its file states it
  PoseSpec tool;                             // in the flange of the arm
  std::vector<FrameSpec> frames;             // of the scenario, in the base
  std::optional<std::string> program_frame;  // as program_frame() says
  std::uint64_t seed = 0;
  Variant variant = Variant::kCounts;
  Engine engine = Engine::kRtl;
  RunFacts facts;
  std::optional<std::string> failure;           // invariant, bus error, RTL assertion: what ended the run early
  std::optional<Cycles> engines_differ_at;      // the cycle, if `failure` is a difference of engines in lock-step
  bool interrupted = false;                     // by the user; such a run is not judged
  std::string program_end;                      // an end of the program that ended the run early; empty: none did
  bool engine_waves_written = false;            // the waveforms of both engines around engines_differ_at
  bool wave_written = false;                    // a waveform was requested and its window has begun
  std::optional<MomentWaveResult> moment_wave;  // of --wave-on
  std::size_t serial_unsent = 0;                // characters and breaks that still waited for the controller at the end
  std::vector<ExpectResult> expect_results;     // of the keys that the scenario states
  std::vector<ExpectFailure> expect_failures;
  GoldenCheck golden;

  // ---- of this machine and moment
  struct Host {
    double wall_s = 0;
    std::int64_t whole_ticks = 0;  // that the engine computed without their edges
  } host;

  // How the run ended: one of outcomes(), or kInterruptedOutcome.
  [[nodiscard]] std::string_view outcome() const { return interrupted ? kInterruptedOutcome : facts.outcome(); }
  [[nodiscard]] bool passed() const {
    return !failure && !interrupted && expect_failures.empty() && golden.verdict != GoldenVerdict::kDiffers;
  }
  // Whether the run has the facts of this group.
  [[nodiscard]] bool has(FactGroup group) const;
  [[nodiscard]] double cycles_per_s() const;      // 0 when no time was measured
  [[nodiscard]] double real_time_factor() const;  // simulated over wall time
};

// What is known before the run. It is that of an interrupted run of no tick.
[[nodiscard]] RunSummary summary_before_run(const Scenario& scenario);

}  // namespace armature::cosim
