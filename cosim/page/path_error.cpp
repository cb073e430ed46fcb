#include "cosim/page/path_error.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "controller/base/angle_units.hpp"
#include "controller/base/math.hpp"
#include "controller/base/words.hpp"
#include "cosim/recording/recorded_path.hpp"
#include "cosim/report/measure/path_error.hpp"
#include "cosim/text/json.hpp"
#include "cosim/trace/columns.hpp"

namespace armature::cosim {
namespace {

// The page has the same bytes on every machine, so the sines are not those of the C library.
Eigen::Isometry3d turn(double angle_deg, Eigen::Index from, Eigen::Index to) {
  const auto [s, c] = math::sin_cos(angle_deg * kRadPerDeg);
  Eigen::Isometry3d turned = Eigen::Isometry3d::Identity();
  turned(from, from) = turned(to, to) = c;
  turned(to, from) = s;
  turned(from, to) = -s;
  return turned;
}

using Joints = std::vector<const NumberColumn*>;  // an angle in each row [deg]

Joints joints_of(const TraceTable& trace, std::size_t count, const std::string& suffix) {
  Joints joints;
  for (std::size_t i = 1; i <= count; ++i) joints.push_back(&trace.column("j" + std::to_string(i) + suffix));
  return joints;
}

// Gives the tool centre point. `arm`: the key of summary.json.
class ArmModel {
 public:
  explicit ArmModel(const Json& arm) {
    for (const Json& link : arm["links"]) {
      const Eigen::Translation3d shift{link["a_mm"].get<double>(), 0.0, link["d_mm"].get<double>()};
      links_.push_back({.sign = link["sign"].get<double>(),
                        .offset_deg = link["offset_deg"].get<double>(),
                        .end = shift * turn(link["alpha_deg"].get<double>(), 1, 2)});
    }
    const Json& tool = arm["tool"]["xyz_mm"];
    tool_mm_ = {tool[0].get<double>(), tool[1].get<double>(), tool[2].get<double>()};
  }

  [[nodiscard]] std::size_t joints() const { return links_.size(); }
  [[nodiscard]] Eigen::Vector3d tool_mm(const Joints& joints, std::size_t row) const {
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const Link& link = links_[i];
      frame = frame * turn(link.sign * joints[i]->number(row) + link.offset_deg, 0, 1) * link.end;
    }
    return frame * tool_mm_;
  }

 private:
  struct Link {
    double sign, offset_deg;
    Eigen::Isometry3d end;  // seen from the turned joint
  };

  std::vector<Link> links_;
  Eigen::Vector3d tool_mm_;
};

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
  const Json arm = run.summary.value("arm", Json(nullptr));
  const bool known = arm.is_object() && arm.contains("links") && arm["links"].is_array();
  if (!known || std::ranges::none_of(moves, has_path)) return std::nullopt;

  const ArmModel model{arm};
  const Joints set_points = joints_of(run.trace, model.joints(), "_ref_deg");
  const Joints encoders = joints_of(run.trace, model.joints(), "_enc_deg");
  const NumberColumn& ticks = run.trace.column(kTickColumn);
  PathErrorMeter meter{arm["memory_ticks"].get<std::int64_t>()};
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
    seen.tool_point = {.reference_mm = model.tool_mm(set_points, row), .encoder_mm = model.tool_mm(encoders, row)};
    meter.add(seen);
    errors.set_points.push_back(value_of(meter.latest().set_point_mm));
    errors.encoders.push_back(value_of(meter.latest().encoder_mm));
  }
  return errors;
}

}  // namespace armature::cosim
