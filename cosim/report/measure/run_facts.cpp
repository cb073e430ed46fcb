#include "cosim/report/measure/run_facts.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "controller/base/angle_units.hpp"
#include "controller/base/overloaded.hpp"
#include "controller/base/timebase.hpp"
#include "cosim/scenario/move_text.hpp"
#include "cosim/text/names.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {

RunFactsCollector::RunFactsCollector(const RobotSpec& robot, std::int64_t settled_counts,
                                     const std::optional<ConveyorSpec>& conveyor, CommandNames names)
    : path_error_{memory_ticks(robot)}, tool_motion_{robot.axis_count} {
  facts_.names = std::move(names);
  if (conveyor) tracking_error_.emplace(robot, *conveyor);
  facts_.settled_counts = settled_counts;
  facts_.axis_count = robot.axis_count;
  for (std::size_t i = 0; i < kAxes; ++i) {
    const AxisSpec& spec = robot.axes[i];
    const double counts_per_rev = static_cast<double>(spec.encoder_lines) * kCountsPerLine;
    axes_[i].counts_per_pulse = counts_per_rev / spec.pulses_per_rev;
    axes_[i].counts_per_turn = counts_per_rev * spec.gear_ratio;
  }
}

void RunFactsCollector::add(const CommandSpec& given) {
  injections_.add(given);
  if (!is_queued(given.kind)) return;
  waiting_.push_back(given.index);
  const PathSpec* path = path_of(given.kind);
  const auto* joint = std::get_if<JointSpec>(&given.kind);
  const bool ends_in_stop = std::holds_alternative<PolylineSpec>(given.kind);
  const bool blends = (path != nullptr && path->blend_mm > 0) || (joint != nullptr && joint->blends());
  if (blends && !ends_in_stop) facts_.blends_asked_for.push_back(given.index);
}

void RunFactsCollector::on_event(const Event& event, Cycles at) {
  std::visit(Overloaded{
                 [&](const MoveStarted& move) { add(move); },
                 [&](const MoveFinished& move) { add(move); },
                 [&](const MoveRefused& refusal) {
                   facts_.refusals.push_back({refusal, at});
                   no_longer_waits(refusal.tag);
                 },
                 [&](const IoDone& done) {
                   injections_.add(done, at);
                   no_longer_waits(done.tag);
                 },
                 [&](const Faulted& fault) {
                   if (!in_fault_) stop_cause_ = fault.cause;  // another one in Fault stops nothing
                   in_fault_ = true;
                   facts_.faults.push_back(
                       {.cause = fault.cause, .where = {.tick = facts_.ticks, .at = at, .axis = fault.axis}});
                   injections_.add(facts_.faults.back());
                   facts_.stops.demand(std::string{word_of(fault.cause)}, facts_.faults.back().where);
                 },
                 [&](const FaultCleared&) {
                   in_fault_ = false;
                   facts_.resets.push_back(at);
                 },
                 [&](const JogStarted& jog) { facts_.jogs.push_back({.started = jog}); },
                 [&](const JogEnded& jog) { facts_.jogs.back().ended = jog; },
                 [&](const HomingStarted& axis) { facts_.homings.push_back({.started = axis}); },
                 [&](const HomingEnded& axis) { add(axis); },
                 [&](const StreamEnded& stream) { add(stream); },
                 [](const OutputSwitched&) {},
                 [&](const PartFollowed& part) { add(part); },
                 [&](const ProgramNoted& note) { add(note, at); },
                 [&](const auto&) {
                   facts_.other_events.push_back({event, at});
                 },
             },
             event);
}

// The waits of a program are answers to inputs, and kOver tells nothing about its lines: the log has them.
void RunFactsCollector::add(const ProgramNoted& note, Cycles at) {
  using enum ProgramNoted::Kind;
  injections_.add(note, at);
  if (note.kind != kWaits && note.kind != kWaited && note.kind != kOver) facts_.program_events.push_back({note, at});
}

void RunFactsCollector::no_longer_waits(Tag tag) {
  if (const auto index = move_index(tag)) std::erase(waiting_, *index);
}

void RunFactsCollector::add(const MoveStarted& move) {
  no_longer_waits(move.tag);
  facts_.moves.push_back(move);
  facts_.taken_ticks.emplace_back();
  path_error_.add(move);
  if (tracking_error_) tracking_error_->add(move);
}

void RunFactsCollector::add(const HomingEnded& axis) {
  const auto run = std::ranges::find_if(
      facts_.homings, [&](const HomingRun& one) { return one.started.axis == axis.axis && !one.ended; });
  if (run != facts_.homings.end()) run->ended = axis;
}

void RunFactsCollector::add(const StreamEnded& stream) {
  facts_.streams.emplace_back(word_of(stream.how));
  for (std::size_t i = 0; i < kAxes; ++i) {
    facts_.stream_deviation_deg[i] = std::max(facts_.stream_deviation_deg[i], stream.deviation_rad[i] * kDegPerRad);
  }
}

void RunFactsCollector::add(const PartFollowed& part) {
  if (part.phase == PartPhase::kMissed) ++facts_.missed_parts;
  if (part.phase == PartPhase::kEnded) facts_.conveyor_ends.emplace_back(word_of(part.end));
  facts_.corrected_ticks += part.corrected;
  facts_.uncorrected_ticks += part.out_of_range;
  facts_.uncorrected_ticks += part.no_result;
  if (tracking_error_) tracking_error_->add(part);
}

// Moves finish in the order in which they start.
void RunFactsCollector::add(const MoveFinished& move) {
  const std::size_t index = over_++;
  if (move.how == MoveFinished::How::kCutShort) return;
  facts_.taken_ticks.at(index) = move.taken.value();
  ++facts_.moves_finished;
}

// The pulses of a tick bring the tool from the set-point of the row before to that of the last one.
void RunFactsCollector::add(OutputChange change) {
  if (tool_before_ && last_.tool_point) {
    const double share =
        static_cast<double>((change.at - Cycles{last_.cycle}).value()) / static_cast<double>(kTickCycles);
    change.tool_mm = *tool_before_ + share * (last_.tool_point->reference_mm - *tool_before_);
  }
  facts_.outputs.push_back(change);
}

void RunFactsCollector::add(const FaultSpec& fault, const RunPlace& when) {
  injections_.add(fault, when);
  if (std::holds_alternative<Estop>(fault.kind)) facts_.stops.demand("estop", when);
}

void RunFactsCollector::add(const BusAbortEvent& abort) {
  if (abort.core == 0) facts_.stops.demand("core 0 stopped", abort.where);
  injections_.add(abort);
  facts_.bus_aborts.push_back(abort);
}

void RunFactsCollector::add_servo_enables(std::uint8_t levels, Cycles at) {
  servo_off_ = levels == 0;
  stopped_ = stopped_ || servo_off_;
  facts_.stops.servo_enables(levels, at);
  if (servo_off_) facts_.servo_off_at = RunPlace{.tick = facts_.ticks, .at = at};
  injections_.servo_enables(levels, at);
}

void RunFactsCollector::add_serial(std::uint8_t byte, bool error, bool is_break) {
  if (!is_break) facts_.serial_sent += static_cast<char>(byte);
  if (error) ++facts_.serial_errors;
}

RunFacts RunFactsCollector::facts() const {
  RunFacts facts = facts_;
  const Telemetry& end = last_.telemetry;
  for (std::size_t i = 0; i < kAxes; ++i) {
    const Axis& axis = axes_[i];
    const std::int64_t encoder = end.encoder[i].value();
    const std::int64_t reference = reference_counts(end, i);
    facts.final_joint_deg[i] = static_cast<double>(encoder) * 360.0 / axis.counts_per_turn;
    facts.total_pulses[i] = last_.pin_pulses[i];
    facts.lost_counts[i] = last_.motor_counts[i] - encoder;
    facts.final_error_counts[i] = reference - encoder;
    if (axis.direction != 0) {
      facts.overshoot_counts[i] = std::max<std::int64_t>(0, axis.farthest - axis.direction * reference);
      if (facts.overshoot_counts[i] > 0) facts.overshoot_at[i] = axis.farthest_at;
    }
  }
  if (last_.load_lead_deg) {
    facts.final_load_deg = make_per_axis([&](std::size_t i) {
      return static_cast<double>(last_.motor_counts[i]) * 360.0 / axes_[i].counts_per_turn + (*last_.load_lead_deg)[i];
    });
    facts.lost_motion_deg = make_per_axis([&](std::size_t i) { return (*most_lead_deg_)[i] - (*least_lead_deg_)[i]; });
  }
  if (end.state == MotionState::kFault) facts.end_fault = end.fault;
  facts.controller_silent = (last_.stopped || servo_off_) && end.state != MotionState::kFault;
  if (facts.controller_silent || (stopped_ && facts.faults.empty())) {
    facts.stopped_by = kControllerSilent;
  } else if (stopped_) {
    facts.stopped_by = word_of(stop_cause_);
  }
  if (last_.tool_point) {
    facts.final_tcp_mm = last_.tool_point->encoder_mm;
    facts.final_rotation = last_.tool_point->encoder_rotation;
  }
  facts.injected_faults = injections_.faults();
  facts.inputs = injections_.inputs();
  facts.path_error = path_error_.of_encoders();
  facts.command_path_error = path_error_.of_set_points();
  facts.peak_tool_speed_mm_s = tool_motion_.speed_mm_s();
  facts.peak_tool_accel_mm_s2 = tool_motion_.accel_mm_s2();
  if (tracking_error_) {
    facts.tracking_error = tracking_error_->of_encoders();
    facts.command_tracking_error = tracking_error_->of_set_points();
    facts.rms_tracking_error_mm = tracking_error_->rms_of_encoders_mm();
    facts.rms_command_tracking_error_mm = tracking_error_->rms_of_set_points_mm();
  }
  facts.moves_waiting = std::ssize(waiting_);
  facts.planning = !waiting_.empty() && last_.load[1].awake_cycles >= kTickCycles;
  facts.moves_under_way = std::ssize(facts_.moves) - static_cast<std::int64_t>(over_);
  if (facts.moved && outside_tick_ < last_.tick) {
    facts.settle_s = static_cast<double>((outside_tick_ + 1 - reference_moved_tick_) * kTickCycles) /
                     static_cast<double>(kClkFreqHz);
  }
  return facts;
}

}  // namespace armature::cosim
