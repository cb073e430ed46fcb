#include "cosim/page/path_error.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "controller/base/axes.hpp"
#include "controller/base/words.hpp"
#include "cosim/recording/recorded_arm.hpp"
#include "cosim/recording/recorded_path.hpp"
#include "cosim/report/measure/path_error.hpp"
#include "cosim/text/json.hpp"
#include "cosim/trace/columns.hpp"

namespace armature::cosim {
namespace {

using Joints = std::vector<const NumberColumn*>;  // an angle in each row [deg]

Joints joints_of(const TraceTable& trace, std::size_t count, const std::string& suffix) {
  Joints joints;
  for (std::size_t i = 1; i <= count; ++i) joints.push_back(&trace.column("j" + std::to_string(i) + suffix));
  return joints;
}

// The tool centre point in this row [mm].
Eigen::Vector3d tool_mm(const RecordedArm& arm, const Joints& joints, std::size_t row) {
  PerAxis<double> angles_deg{};
  for (std::size_t i = 0; i < joints.size(); ++i) angles_deg[i] = joints[i]->number(row);
  return arm.tool(angles_deg).translation();
}

bool has_path(const Json& move) {
  return move.contains("path");
}

std::int64_t start_of(const Json& move) {
  return move.value("start_tick", std::int64_t{0});
}

// Tells the meter that the move starts.
void start(const Json& move, PathErrorMeter& meter) {
  if (move.value("kind", "") == "dwell") return;
  std::optional<RecordedPath> recorded = recorded_path(move);
  if (!recorded || move.value("on_conveyor", false)) return meter.leave_path();
  meter.start_path({.path = recorded->path, .start_tick = start_of(move), .curve = std::move(recorded->curve)},
                   move.value("continues", false));
}

std::int64_t value_of(const std::optional<double>& mm) {
  return mm && std::isfinite(*mm) ? std::llround(*mm * 1e6) : PathErrors::kNone;
}

}  // namespace

std::optional<PathErrors> path_errors(const RunRecord& run) {
  const Json& moves = run.summary["result"]["moves"];
  const std::optional<RecordedArm> arm = RecordedArm::of(run.summary);
  if (!arm || std::ranges::none_of(moves, has_path)) return std::nullopt;

  const Joints set_points = joints_of(run.trace, arm->joints(), "_ref_deg");
  const Joints encoders = joints_of(run.trace, arm->joints(), "_enc_deg");
  const NumberColumn& ticks = run.trace.column(kTickColumn);
  PathErrorMeter meter{run.summary["arm"]["memory_ticks"].get<std::int64_t>()};
  PathErrors errors;
  auto move = moves.begin();
  std::span<const StateSpan> states = run.trace.states;
  for (std::size_t row = 0; row < run.trace.rows(); ++row) {
    for (; move != moves.end() && start_of(*move) <= ticks.values[row]; ++move) start(*move, meter);
    while (states.size() > 1 && states[1].first_row <= row) states = states.subspan(1);
    TraceRow seen;
    seen.tick = ticks.values[row];
    for (std::size_t i = 0; i < set_points.size(); ++i)
      seen.telemetry.reference[i] = Radians{set_points[i]->number(row)};
    if (!states.empty() && states[0].state == word_of(MotionState::kFault)) seen.telemetry.state = MotionState::kFault;
    seen.tool_point = {.reference_mm = tool_mm(*arm, set_points, row), .encoder_mm = tool_mm(*arm, encoders, row)};
    meter.add(seen);
    errors.set_points.push_back(value_of(meter.latest().set_point_mm));
    errors.encoders.push_back(value_of(meter.latest().encoder_mm));
  }
  return errors;
}

}  // namespace armature::cosim
