// A run that a program outside steers: it advances the run, reads its trace, sends velocities and set-points, and goes
// back to an earlier time.
//
//   SteeredRun run{load_scenario("scenarios/jog")};
//   run.advance(to_cycles(0.02));
//   run.jog({.joint_deg_s = PerAxis<double>{10, 0, 0, 0, 0, 0}, .duration_s = 0.1});
//   const RunSnapshot here = run.snapshot();
//   while (run.advance(to_cycles(0.001))) {}
//
// What is sent passes through the script of the run, to the controller's client of the scenario, in the cycle of now().
// So a run is the same as that of a scenario with these commands at these times, and nothing depends on how it is cut
// into steps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "controller/base/axes.hpp"
#include "controller/base/units.hpp"
#include "cosim/report/judge/run_summary.hpp"
#include "cosim/run/golden_listener.hpp"
#include "cosim/run/run.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/steer/trace_columns.hpp"

namespace armature::cosim {

// A set-point of a stream: joint angles [deg], or x, y, z [mm], roll, pitch, yaw [deg] of the tool in the base.
struct SetPoint {
  StreamSpec::Kind kind = StreamSpec::Kind::kJoints;
  std::array<double, 6> values{};
  bool last = false;     // the stream ends with it
  double delay_ms = 10;  // of the first one: as `delay_ms` of [[stream]]
};

// A time of a run, and all that was sent before it: enough to come there again, on every machine.
struct RunSnapshot {
  struct Sent {
    Cycles at;
    std::variant<JogSpec, SetPoint> what;
  };
  Cycles at{};
  std::vector<Sent> sent{};
};

class SteeredRun {
 public:
  struct Options {
    std::int64_t every_ticks = 1;  // rows of the trace that are kept, at least 1
    bool compare_golden = false;   // the summary then has the verdict of the golden
  };

  // At cycle 0. Throws what Run and TraceColumns throw.
  SteeredRun(Scenario scenario, const Options& options);
  // At the time of a snapshot of a run of the same scenario, in the state that it had: the run is repeated. Its trace
  // has all rows.
  SteeredRun(Scenario scenario, const Options& options, const RunSnapshot& snapshot);
  SteeredRun(const SteeredRun&) = delete;
  SteeredRun& operator=(const SteeredRun&) = delete;

  // Continues for so many cycles, or to the end of the run. Returns false when the run is over.
  bool advance(Cycles duration);
  [[nodiscard]] Cycles now() const { return run_.now(); }
  [[nodiscard]] bool over() const { return over_; }

  // Sends a velocity of the joints or of the tool; the members are the keys of `type = "jog"`, without `profile`; the
  // index of the frame follows from its name. Throws InputError when a value is outside the range of its key or the run
  // is over, as does send().
  void jog(JogSpec jog);
  // Sends a set-point. The first one begins a stream, as does the next one after the last one of a stream. All others
  // come a whole number of ticks after the first one, and at different times.
  void send(const SetPoint& point);

  [[nodiscard]] RunSnapshot snapshot() const { return {.at = now(), .sent = sent_}; }

  [[nodiscard]] const Scenario& scenario() const { return scenario_; }
  [[nodiscard]] const TraceColumns& trace() const { return trace_; }
  // Of all rows so far, as `sha256` of summary.json.
  [[nodiscard]] std::string digest() const;
  // Refused commands so far, the latest reason; empty: none.
  [[nodiscard]] std::size_t refused() const { return refusals_.count; }
  [[nodiscard]] std::string_view last_refusal() const { return refusals_.last; }

  // Ends the run; one that is not over as interrupted. Call it once, then only the trace, the digest and the times.
  [[nodiscard]] RunSummary finish();

 private:
  struct Refusals final : public RunListener {
    void on_row(const TraceRow&, const IntegerDigest& now) override { digest = &now; }
    void on_event(const Event& event, const RunPlace&) override;
    const IntegerDigest* digest = nullptr;  // of the run
    std::size_t count = 0;
    std::string_view last;
  };
  void begin_stream(const SetPoint& first);
  void require_going_on(const char* what) const;

  Scenario scenario_;  // with the streams that were sent
  TraceColumns trace_;
  std::optional<GoldenListener> golden_;
  Refusals refusals_;
  Run run_;
  std::vector<RunSnapshot::Sent> sent_;
  std::uint32_t next_move_;
  std::optional<Cycles> stream_begin_;  // of the stream that goes on
  bool over_ = false;
};

}  // namespace armature::cosim
