// A run with all files that listeners write, and a scenario in which all kinds of things happen within 60 ms.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cosim/report/format/json/summary_json.hpp"
#include "cosim/run/load_listener.hpp"
#include "cosim/run/log_listener.hpp"
#include "cosim/run/run.hpp"
#include "cosim/run/serial_listener.hpp"
#include "cosim/run/trace_listener.hpp"
#include "tests/cosim/support/scenario_files.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim::test {

// In a test, `Run` is a member of the test's base class.
using RunUnderTest = Run;

// A move, an input that a command waits for, an output, an emergency stop, characters to the controller.
inline Scenario lively_scenario() {
  Scenario scenario = scenario_with(R"([serial]
[[move]]
at_s = 0.003
type = "joint"
target_deg = [0.05, -0.05, 0.02, 0.02, -0.02, 0.03]
[[move]]
at_s = 0.003
type = "wait_din"
pin = 3
level = 1
[[move]]
at_s = 0.003
type = "dout"
pin = 2
level = 1
[[input]]
at_s = 0.03
pin = 3
level = 1
[[fault]]
at_s = 0.045
kind = "estop"
duration_s = 0.01
[[serial_send]]
at_s = 0.004
text = "armature"
)");
  scenario.engine = Engine::kModel;
  scenario.duration_s = 0.06;
  return scenario;
}

// The teach pendant and the controller talk, and the arm moves.
inline Scenario pendant_scenario() {
  Scenario scenario = load_scenario(kScenarios / "pendant_moves", shipped());
  scenario.engine = Engine::kModel;
  scenario.duration_s = 0.06;
  return scenario;
}

// The texts of all files, and the summary.
struct RunTexts {
  std::string trace, load, log, serial, summary;
  friend bool operator==(const RunTexts&, const RunTexts&) = default;
};

class RecordedRun {
 public:
  explicit RecordedRun(const Scenario& scenario)
      : log_{scenario, folder_.path() / "log.txt"},
        trace_{scenario, {.file = folder_.path() / "trace.csv", .every_ticks = 1}},
        run_{scenario} {
    for (RunListener* listener : std::vector<RunListener*>{&log_, &trace_, &load_, &serial_}) run_.add(*listener);
  }

  [[nodiscard]] Run& run() { return run_; }

  [[nodiscard]] RunTexts finish() {
    const std::string summary = summary_json(run_.finish());
    const auto text = [this](const char* name) { return read_file(folder_.path() / name); };
    return {text("trace.csv"), text("load.csv"), text("log.txt"), text("serial.csv"), summary};
  }

 private:
  TempFolder folder_;
  LogListener log_;
  TraceListener trace_;
  LoadListener load_{{.file = folder_.path() / "load.csv", .every_ticks = 1}};
  SerialListener serial_{folder_.path() / "serial.csv"};
  Run run_;
};

}  // namespace armature::cosim::test
