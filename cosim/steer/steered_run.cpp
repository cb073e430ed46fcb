#include "cosim/steer/steered_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <span>
#include <utility>
#include <variant>

#include "controller/base/overloaded.hpp"
#include "cosim/run/run_folder.hpp"
#include "cosim/scenario/moves/jog.hpp"
#include "cosim/scenario/moves/pose.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/names.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

// A not-a-number is outside, too.
void require_between(const char* what, const std::string& name, std::span<const double> values, double limit) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::fabs(values[i]) <= limit) continue;
    throw InputError{what, fmt::format("{}[{}]: expected {} to {}, found {}", name, i, -limit, limit, values[i])};
  }
}

void require_above_zero(const char* what, const std::string& name, double value, double limit) {
  if (value > 0 && value <= limit) return;
  throw InputError{what, fmt::format("{}: expected more than 0, at most {}, found {}", name, limit, value)};
}

void require_valid(const JogSpec& jog, const RobotSpec& robot) {
  constexpr const char* kWhat = "jog";
  if (!jog.joint_deg_s && (robot.axis_count != kAxes || !robot.kinematics)) {
    throw InputError{kWhat, "a velocity of the tool needs six axes and [kinematics] of the robot"};
  }
  require_above_zero(kWhat, "duration_s", jog.duration_s, kMaxDurationS);
  if (jog.joint_deg_s) require_between(kWhat, "joint_deg_s", *jog.joint_deg_s, kMaxSpeed);
  require_between(kWhat, "tool_mm_s", jog.tool_mm_s, kMaxSpeed);
  require_between(kWhat, "tool_deg_s", jog.tool_deg_s, kMaxSpeed);
  if (!(jog.accel_percent >= kMinJogAccelPercent && jog.accel_percent <= 100)) {
    throw InputError{
        kWhat, fmt::format("accel_percent: expected {} to 100, found {}", kMinJogAccelPercent, jog.accel_percent)};
  }
  if (jog.profile != ProfileKind::kTrapezoid) throw InputError{kWhat, "profile: expected trapezoid"};
}

std::size_t frame_of(const std::string& name, const Scenario& scenario) {
  std::size_t frame = 0;
  const std::string problem = find_frame(name, frame, {.scenario = &scenario});
  if (!problem.empty()) throw InputError{"jog", problem};
  return frame;
}

void require_valid(const SetPoint& point) {
  constexpr const char* kWhat = "set-point";
  const std::span values{point.values};
  if (point.kind == StreamSpec::Kind::kJoints) {
    require_between(kWhat, "joints_deg", values, kMaxAngleDeg);
    return;
  }
  require_between(kWhat, "xyz_mm", values.first(3), kMaxPlaceMm);
  require_between(kWhat, "rpy_deg", values.last(3), kMaxAngleDeg);
}

}  // namespace

void SteeredRun::Refusals::on_event(const Event& event, const RunPlace&) {
  const auto* refused = std::get_if<MoveRefused>(&event);
  if (refused == nullptr) return;
  ++count;
  last = word_of(refused->reason);
}

SteeredRun::SteeredRun(Scenario scenario, const Options& options)
    : scenario_{std::move(scenario)},
      trace_{scenario_, options.every_ticks},
      run_{scenario_},
      next_move_{static_cast<std::uint32_t>(scenario_.moves.size())} {
  run_.add(trace_);
  run_.add(refusals_);
  if (options.compare_golden) run_.add(golden_.emplace(scenario_, TraceFile{kTraceFile, scenario_.trace.every_ticks}));
}

SteeredRun::SteeredRun(Scenario scenario, const Options& options, const RunSnapshot& snapshot)
    : SteeredRun{std::move(scenario), options} {
  for (const RunSnapshot::Sent& sent : snapshot.sent) {
    advance(sent.at - now());
    std::visit(Overloaded{[this](const JogSpec& spec) { jog(spec); }, [this](const SetPoint& point) { send(point); }},
               sent.what);
  }
  advance(snapshot.at - now());
}

bool SteeredRun::advance(Cycles duration) {
  if (!over_) over_ = !run_.advance(now() + duration);
  return !over_;
}

void SteeredRun::require_going_on(const char* what) const {
  if (over_) throw InputError{what, "the run is over"};
}

void SteeredRun::jog(JogSpec jog) {
  require_valid(jog, scenario_.robot);
  require_going_on("jog");
  jog.frame = frame_of(jog.frame_name, scenario_);
  if (next_move_ == kFirstStreamTag) throw InputError{"jog", "a run can take no more commands"};
  run_.add_action(CommandSpec{.at_s = to_seconds(now()), .kind = jog, .index = next_move_++});
  sent_.push_back({now(), std::move(jog)});
}

void SteeredRun::begin_stream(const SetPoint& first) {
  require_above_zero("set-point", "delay_ms", first.delay_ms, kMaxStreamDelayMs);
  scenario_.streams.push_back({.at_s = to_seconds(now()),
                               .file_name = "set-points from outside",
                               .delay_ms = first.delay_ms,
                               .kind = first.kind,
                               .points = {},
                               .index = scenario_.streams.size()});
  stream_begin_ = now();
}

void SteeredRun::send(const SetPoint& point) {
  constexpr const char* kWhat = "set-point";
  require_valid(point);
  require_going_on(kWhat);
  if (!stream_begin_) begin_stream(point);
  StreamSpec& stream = scenario_.streams.back();
  if (point.kind != stream.kind) throw InputError{kWhat, "a stream is either of joints or of the tool"};
  const Cycles time = now() - *stream_begin_;
  const std::int64_t ticks = time.value() / kTickCycles;
  if (time.value() % kTickCycles != 0 || (!stream.points.empty() && ticks <= stream.points.back().ticks)) {
    throw InputError{kWhat, fmt::format("expected a whole number of ticks after the first one, and later than the one "
                                        "before, found {} cycles",
                                        time.value())};
  }
  stream.points.push_back({.ticks = ticks, .values = point.values});
  run_.add_action(StreamStep{.stream = stream.index, .point = stream.points.size() - 1, .more = !point.last});
  if (point.last) stream_begin_.reset();
  sent_.push_back({now(), point});
}

std::string SteeredRun::digest() const {
  return refusals_.digest == nullptr ? IntegerDigest{}.hex() : refusals_.digest->hex();
}

RunSummary SteeredRun::finish() {
  over_ = true;
  return run_.finish();
}

}  // namespace armature::cosim
