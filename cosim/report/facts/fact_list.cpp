#include <algorithm>
#include <cassert>

#include "cosim/report/facts/fact_entry.hpp"
#include "cosim/report/facts/fact_words.hpp"
#include "cosim/text/names.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

using E = ExpectSpec;
using F = RunFacts;

constexpr std::string_view kNotStated = "0, as it is not stated";

template <auto kMember>
FactWhere place_of(const RunFacts& facts) {
  return at_place(facts.*kMember);
}
template <auto kMember>
FactWhere place_of_peak(const RunFacts& facts) {
  return facts.*kMember ? at_place((facts.*kMember)->at) : FactWhere{};
}
template <auto kMember>
PerAxis<std::optional<RunPlace>> places_of(const RunFacts& facts) {
  return facts.*kMember;
}

template <MotionState kState>
FactValue most_instructions_in(const RunFacts& facts) {
  return facts.most_instructions.at(static_cast<std::size_t>(kState));
}

// Formatted by hand, because the formatter would put each field on its own line.
// clang-format off
std::vector<Fact> make_list() {
  return {
    // ---- length of the run, load of the bus and the core
    {.name = "outcome", .unit = "", .meaning = "End of the run: `completed`, `interrupted`, or `fault:` and the cause",
     .value = measured<&F::outcome>, .group = FactGroup::kEvents,
     .expectations = {equal<&E::outcome>("outcome")},
     .where = at_faults, .otherwise = {{std::string{kCompleted}, kCompleted}}},
    {.name = "simulated_s", .unit = "s", .meaning = "Simulated time of the run",
     .value = measured<&F::simulated_s>},
    {.name = "ticks", .unit = "", .meaning = "Triggers that the controller has processed",
     .value = measured<&F::ticks>},
    {.name = "cycles", .unit = "", .meaning = "Simulated clock cycles",
     .value = measured<&F::cycles>},
    {.name = "bus_reads", .unit = "", .meaning = "Bus reads of both cores",
     .value = measured<&F::bus_reads>},
    {.name = "bus_writes", .unit = "", .meaning = "Bus writes of both cores",
     .value = measured<&F::bus_writes>},
    {.name = "worst_tick_cycles", .unit = "cycles", .meaning = "Longest time that core 0 needed for one tick",
     .value = measured<&F::worst_tick>},
    {.name = "tick_cycles", .unit = "cycles", .meaning = "Length of one tick",
     .value = [](const RunFacts&) -> FactValue { return kTickCycles; }},

    // ---- moves
    {.name = "moves_finished", .unit = "", .meaning = "Moves that reached their end",
     .value = measured<&F::moves_finished>},
    {.name = "moves_waiting", .unit = "",
     .meaning = "Moves and commands for pins that had not begun at the end of the run",
     .value = measured<&F::moves_waiting>},
    {.name = "moves_under_way", .unit = "", .meaning = "Moves that had begun and not ended at the end of the run",
     .value = measured<&F::moves_under_way>},
    {.name = "refused_moves", .unit = "", .meaning = "Moves that were refused or dropped",
     .value = refused_moves, .group = FactGroup::kEvents,
     .expectations = {equal<&E::refused_moves>("refused_moves")}, .in_words = refused_moves_text, .where = at_refusals,
     .otherwise = {{std::int64_t{0}, kNotStated, "refusals"}}},
    {.name = "refusals", .unit = "", .meaning = "Reasons of all refused moves, in the order of time",
     .value = refusals, .group = FactGroup::kEvents,
     .expectations = {equal<&E::refusals>("refusals")}, .where = at_refusals},
    {.name = "jog_ends", .unit = "", .meaning = "Why each jog ended, in the order of time",
     .value = jog_ends, .group = FactGroup::kEvents,
     .expectations = {equal<&E::jog_ends>("jog_ends")}},
    {.name = "homing_ends", .unit = "", .meaning = "How the homing of each axis ended, in the order of time",
     .value = homing_ends, .group = FactGroup::kEvents,
     .expectations = {equal<&E::homing_ends>("homing_ends")}},
    {.name = "unfinished_moves", .unit = "", .meaning = "Moves that were waiting or under way at the end of the run",
     .value = unfinished_moves, .group = FactGroup::kEvents,
     .expectations = {equal<&E::unfinished_moves>("unfinished_moves")}, .in_words = unfinished_moves_text,
     .otherwise = {{std::int64_t{0}, kNotStated}}},
    {.name = "blended_moves", .unit = "", .meaning = "Moves that began without a stop",
     .value = measured<&F::blended_moves>,
     .expectations = {equal<&E::blended_moves>("blended_moves")}},
    {.name = "unasked_stops", .unit = "",
     .meaning = "Stops between two moves of a chain that nobody asked for, see `unasked_stops` in [KEYS.md](KEYS.md)",
     .value = [](const F& facts) -> FactValue { return facts.unasked_stops(); },
     .screen = {"unasked stops", 6, true},
     .expectations = {equal<&E::unasked_stops>("unasked_stops")}, .where = at_unasked_stops,
     .otherwise = {{std::int64_t{0}, kNotStated}}},
    {.name = "move_ticks", .unit = "ticks", .meaning = "Planned duration of each move that began",
     .value = move_ticks, .group = FactGroup::kEvents,
     .expectations = {equal<&E::move_ticks>("move_ticks")}},
    {.name = "taken_ticks", .unit = "ticks", .meaning = "Duration of each finished move, with holds",
     .value = taken_ticks, .group = FactGroup::kEvents,
     .expectations = {equal<&E::taken_ticks>("taken_ticks")}},
    {.name = "profile", .unit = "", .meaning = "Shape of the speed of each axis in the first move",
     .value = first_profile, .group = FactGroup::kEvents,
     .expectations = {{.key = "profile", .wanted = wanted_profile}}, .in_words = first_profile_text},
    {.name = "held_s", .unit = "s", .meaning = "Total time for which a hold stopped the set-points",
     .value = measured<&F::held_s>, .screen = {"time in holds", 6, true},
     .expectations = {at_least<&E::min_held_s>("min_held_s")}},

    {.name = "streams", .unit = "", .meaning = "End of each stream: `complete`, `late`, `stopped` or `fault`",
     .value = measured<&F::streams>,
     .expectations = {equal<&E::streams>("streams")}},
    {.name = "stream_deviation_deg", .unit = "deg",
     .meaning = "Largest distance of the set-points of each axis from the streams, with their delay",
     .value = measured<&F::stream_deviation_deg>, .screen = {"off the stream deg", 6, true}},
    {.name = "max_stream_deviation_deg", .unit = "deg", .meaning = "The same of any axis",
     .value = measured<&F::max_stream_deviation_deg>,
     .expectations = {at_most<&E::max_stream_deviation_deg>("max_stream_deviation_deg")}},

    {.name = "conveyor_ends", .unit = "", .meaning = "Why the arm stopped following each part, in the order of time",
     .value = measured<&F::conveyor_ends>,
     .expectations = {equal<&E::conveyor_ends>("conveyor_ends")}},
    {.name = "missed_parts", .unit = "", .meaning = "Parts that had passed the window before a move waited for them",
     .value = measured<&F::missed_parts>, .screen = {"missed parts", 6, true},
     .expectations = {equal<&E::missed_parts>("missed_parts")}},
    {.name = "tracking_error", .unit = "mm",
     .meaning = "Largest distance of the tool from its path on the moving part, by the encoders",
     .value = measured<&F::tracking_error>, .screen = {"tracking error"},
     .expectations = {at_most<&E::max_tracking_error_mm>("max_tracking_error_mm")},
     .in_words = deviation_text<&F::tracking_error>, .where = deviation_where<&F::tracking_error>},
    {.name = "command_tracking_error", .unit = "mm", .meaning = "The same of the set-points",
     .value = measured<&F::command_tracking_error>, .screen = {"  of the set-points"},
     .expectations = {at_most<&E::max_command_tracking_error_mm>("max_command_tracking_error_mm")},
     .in_words = deviation_text<&F::command_tracking_error>, .where = deviation_where<&F::command_tracking_error>},
    {.name = "rms_tracking_error_mm", .unit = "mm",
     .meaning = "Root mean square of the distance of which `tracking_error` is the largest, over all ticks in which it is "
                "measured",
     .value = measured<&F::rms_tracking_error_mm>},
    {.name = "rms_command_tracking_error_mm", .unit = "mm", .meaning = "The same of the set-points",
     .value = measured<&F::rms_command_tracking_error_mm>},
    {.name = "corrected_ticks", .unit = "",
     .meaning = "Ticks in which the network of `[conveyor.policy]` corrected where the belt is expected",
     .value = measured<&F::corrected_ticks>, .screen = {"ticks with a network", 6, true},
     .expectations = {at_least<&E::min_corrected_ticks>("min_corrected_ticks"),
                      at_most<&E::max_corrected_ticks>("max_corrected_ticks")}},
    {.name = "uncorrected_ticks", .unit = "",
     .meaning = "Ticks in which it did not: the belt was outside the ranges of training, or there was no result in time",
     .value = measured<&F::uncorrected_ticks>, .screen = {"  without a result", 6, true},
     .expectations = {at_least<&E::min_uncorrected_ticks>("min_uncorrected_ticks"),
                      at_most<&E::max_uncorrected_ticks>("max_uncorrected_ticks")}},

    {.name = "solved_poses", .unit = "",
     .meaning = "Set-points whose joint angles are those of the block `ik_cordic`, see `[kinematics]` in [KEYS.md](KEYS.md)",
     .value = measured<&F::solved_poses>, .screen = {"poses by ik_cordic", 0, true},
     .expectations = {at_least<&E::min_solved_poses>("min_solved_poses")}},
    {.name = "solver_difference_pulses", .unit = "pulses",
     .meaning = "Largest difference of such a joint angle from software, of any axis",
     .value = measured<&F::solver_difference_pulses>, .screen = {"  from software", 4, true},
     .expectations = {at_most<&E::max_solver_difference_pulses>("max_solver_difference_pulses")}},

    // ---- faults
    {.name = "underruns", .unit = "", .meaning = "Ticks whose pulse counts came too late for the logic",
     .value = measured<&F::underruns>, .screen = {"underruns"},
     .expectations = {equal<&E::underruns>("underruns"), at_least<&E::min_underruns>("min_underruns")},
     .where = [](const F& facts) { return first_at(facts.first_underrun_at); },
     .otherwise = {{std::int64_t{0}, kNotStated}}},
    {.name = "stopped_by", .unit = "",
     .meaning = "Cause of the last drop of the servo enables. `null`: they did not drop",
     .value = stopped_by,
     .expectations = {equal<&E::stopped_by>("stopped_by")}, .in_words = stopped_by_text, .where = at_faults},
    {.name = "missed_stop", .unit = "",
     .meaning = "The first stop that was demanded and after which the servo enables stayed on for more than 1 ms, or for a "
                "tick more than `drop_out_us` if that is longer. Such a run never passes. `null`: there was none",
     .value = missed_stop, .where = at_missed_stop, .otherwise = {{std::string{"none"}, "none, in any run"}}},
    {.name = "faults", .unit = "", .meaning = "Causes of all faults that the controller reported, in the order of time",
     .value = fault_causes, .group = FactGroup::kEvents,
     .expectations = {equal<&E::faults>("faults")}, .where = at_faults},
    {.name = "bus_error", .unit = "", .meaning = "First error response of the bus that stopped a core",
     .value = measured<&F::bus_error>, .group = FactGroup::kEvents,
     .expectations = {equal<&E::bus_error>("bus_error")}, .where = at_bus_aborts,
     .otherwise = {{std::string{bus_error_name(BusError::kNone)}, "none, as it is not stated"}}},

    {.name = "missing_ticks", .unit = "ticks",
     .meaning = "Triggers that did not come, because the clock of the logic or its timer stood still",
     .value = [](const F& facts) -> FactValue { return facts.missing_ticks(); },
     .expectations = {equal<&E::missing_ticks>("missing_ticks")}, .where = last_trigger,
     .otherwise = {{std::int64_t{0}, kNotStated}}},
    {.name = "unanswered_faults", .unit = "",
     .meaning = "Injected faults to which nothing responded, see `unanswered_faults` in [KEYS.md](KEYS.md)",
     .value = [](const F& facts) -> FactValue { return facts.unanswered_faults(); }, .group = FactGroup::kEvents,
     .expectations = {equal<&E::unanswered_faults>("unanswered_faults")}, .where = at_unanswered_faults,
     .otherwise = {{std::int64_t{0}, kNotStated}}},
    {.name = "stop_ticks", .unit = "ticks",
     .meaning = "Longest time from the begin of an injected fault to the first servo enable that drops after it",
     .value = measured<&F::stop_ticks>, .group = FactGroup::kEvents,
     .expectations = {at_most<&E::max_stop_ticks>("max_stop_ticks")}, .in_words = stop_ticks_text,
     .where = at_longest_stop},

    // ---- axes
    {.name = "final_joint_deg", .unit = "deg", .meaning = "Joint angle of each axis at the end, by the encoder",
     .value = measured<&F::final_joint_deg>, .screen = {"final angle deg", 4},
     .expectations = {within<&E::final_joint_deg, &E::tolerance_deg>("final_joint_deg", "tolerance_deg")}},
    {.name = "final_load_deg", .unit = "deg",
     .meaning = "True angle of each joint at the end, behind its gear. `null`: not with `plant = \"dynamic\"`, so the gears "
                "are rigid",
     .value = measured<&F::final_load_deg>, .screen = {"final load angle deg", 4},
     .expectations = {within<&E::final_load_deg, &E::load_tolerance_deg>("final_load_deg", "load_tolerance_deg")}},
    {.name = "lost_motion_deg", .unit = "deg",
     .meaning = "By how much each joint moved relative to its motor in the run: play and twist of its gear. `null`: "
                "likewise",
     .value = measured<&F::lost_motion_deg>, .screen = {"lost motion deg", 4},
     .expectations = {within<&E::lost_motion_deg, &E::lost_motion_tolerance_deg>("lost_motion_deg",
                                                                                 "lost_motion_tolerance_deg")}},
    {.name = "final_error_counts", .unit = "counts", .meaning = "Reference minus encoder of each axis at the end",
     .value = measured<&F::final_error_counts>, .screen = {"final error counts"},
     .expectations = {equal<&E::final_error_counts>("final_error_counts")}},
    {.name = "total_pulses", .unit = "pulses", .meaning = "Net pulses of each axis on the pins at the end",
     .value = measured<&F::total_pulses>, .screen = {"pulses"},
     .expectations = {equal<&E::total_pulses>("total_pulses")}},
    {.name = "peak_speed_deg_s", .unit = "deg/s",
     .meaning = "Largest speed of the set-points of each axis, except during a fault",
     .value = measured<&F::peak_speed_deg_s>, .screen = {"peak speed deg/s", 3},
     .expectations = {within<&E::peak_speed_deg_s, &E::peak_tolerance_deg_s>("peak_speed_deg_s",
                                                                             "peak_tolerance_deg_s")},
     .axis_places = places_of<&F::peak_speed_at>},
    {.name = "peak_pulses_per_tick", .unit = "pulses", .meaning = "Largest number of pulses of any axis in one tick",
     .value = measured<&F::peak_pulses_per_tick>,
     .expectations = {equal<&E::peak_pulses_per_tick>("peak_pulses_per_tick")}, .where = place_of<&F::peak_pulses_at>},
    {.name = "worst_following_error_deg", .unit = "deg",
     .meaning = "Largest difference between encoder and reference of each axis, except during a fault",
     .value = measured<&F::worst_following_error_deg>, .screen = {"worst following deg", 4},
     .axis_places = places_of<&F::worst_following_error_at>},
    {.name = "overshoot_counts", .unit = "counts",
     .meaning = "Largest overshoot of the encoder of each axis beyond the final reference, after its last reversal",
     .value = measured<&F::overshoot_counts>,
     .expectations = {at_most<&E::max_overshoot_counts>("max_overshoot_counts")},
     .axis_places = places_of<&F::overshoot_at>},
    {.name = "max_correction_pulses", .unit = "pulses", .meaning = "Largest correction of any axis by the feedback",
     .value = measured<&F::max_correction_pulses>,
     .expectations = {at_most<&E::max_correction_pulses>("max_correction_pulses")},
     .where = place_of<&F::max_correction_at>},
    {.name = "settle_s", .unit = "s",
     .meaning = "Time from the last motion of the set-points until every encoder stays within `settled_counts`. "
                "`null`: not settled, or no motion",
     .value = measured<&F::settle_s>,
     .expectations = {at_most<&E::settled_within_s>("settled_within_s")}, .in_words = settle_text,
     .where = last_outside},

    // ---- tool
    {.name = "final_tcp_mm", .unit = "mm",
     .meaning = "Position of the tool centre point in the base frame at the end, by the encoders",
     .value = measured<&F::final_tcp_mm>, .screen = {"final tcp mm (x y z)", 4},
     .expectations = {within<&E::final_tcp_mm, &E::tcp_tolerance_mm>("final_tcp_mm", "tcp_tolerance_mm")},
     .in_words = tool_text<&F::final_tcp_mm>},
    {.name = "final_rpy_deg", .unit = "deg",
     .meaning = "Roll, pitch and yaw of the tool in the base frame at the end, by the encoders",
     .value = measured<&F::final_rotation>, .screen = {"final rpy deg", 4},
     .expectations = {{.key = "final_rpy_deg", .relation = Relation::kWithin, .wanted = wanted_orientation,
                       .tolerance = [](const E& expect) { return expect.rpy_tolerance_deg; },
                       .tolerance_key = "rpy_tolerance_deg"}},
     .in_words = tool_text<&F::final_rotation>},
    {.name = "path_error", .unit = "mm", .meaning = "Largest distance of the tool from its path, by the encoders",
     .value = measured<&F::path_error>, .screen = {"worst path error"},
     .expectations = {at_most<&E::max_path_error_mm>("max_path_error_mm")}, .in_words = deviation_text<&F::path_error>,
     .where = deviation_where<&F::path_error>},
    {.name = "command_path_error", .unit = "mm", .meaning = "Largest distance of the set-points from their path",
     .value = measured<&F::command_path_error>, .screen = {"  of the set-points"},
     .expectations = {at_most<&E::max_command_path_error_mm>("max_command_path_error_mm")},
     .in_words = deviation_text<&F::command_path_error>,
     .where = deviation_where<&F::command_path_error>},
    {.name = "peak_tool_speed_mm_s", .unit = "mm/s",
     .meaning = "Largest speed of the tool centre point in the base frame: the distance of the set-points of two ticks, "
                "divided by a tick. A corner with a joint move may exceed the speed of the path. It is not measured in a "
                "fault and while a joint angle is not known. `null`: never measured, or the robot has no kinematics",
     .value = measured<&F::peak_tool_speed_mm_s>,
     .expectations = {at_most<&E::max_tool_speed_mm_s>("max_tool_speed_mm_s")},
     .where = place_of_peak<&F::peak_tool_speed_mm_s>},
    {.name = "peak_tool_accel_mm_s2", .unit = "mm/s^2",
     .meaning = "Its largest acceleration: the second difference of the set-points of three ticks, divided by the square "
                "of a tick",
     .value = measured<&F::peak_tool_accel_mm_s2>,
     .expectations = {at_most<&E::max_tool_accel_mm_s2>("max_tool_accel_mm_s2")},
     .where = place_of_peak<&F::peak_tool_accel_mm_s2>},
    {.name = "largest_stretch", .unit = "",
     .meaning = "Largest factor by which a move was slowed down for its joints. 1: no move was slowed down",
     .value = measured<&F::largest_stretch>,
     .expectations = {at_least<&E::min_stretch>("min_stretch"), at_most<&E::max_stretch>("max_stretch")},
     .nothing_to_judge = no_path},
    {.name = "largest_residual_deg", .unit = "deg",
     .meaning = "Largest angle by which the orientation of the tool leaves what a move requested, as planned",
     .value = measured<&F::largest_residual_deg>,
     .expectations = {at_least<&E::min_residual_deg>("min_residual_deg"),
                      at_most<&E::max_residual_deg>("max_residual_deg")},
     .nothing_to_judge = no_path},
    {.name = "sha256", .unit = "", .meaning = "Digest of every tick, see above",
     .value = measured<&F::sha256>},

    // ---- the variant of the paper
    {.name = "inexact_ticks", .unit = "",
     .meaning = "Ticks, for each axis, that emitted another count than the controller intended",
     .value = measured<&F::inexact_ticks>, .group = FactGroup::kPaper, .screen = {"inexact ticks"},
     .expectations = {equal<&E::inexact_ticks>("inexact_ticks")}},
    {.name = "max_residual_pulses", .unit = "pulses",
     .meaning = "Largest difference of any axis between intended and emitted count. The next ticks compensate it",
     .value = measured<&F::max_residual_pulses>, .group = FactGroup::kPaper, .screen = {"largest residual"},
     .expectations = {at_most<&E::max_residual_pulses>("max_residual_pulses")}, .where = place_of<&F::max_residual_at>},
    {.name = "lost_counts", .unit = "counts",
     .meaning = "Net counts of each motor that the controller did not see",
     .value = measured<&F::lost_counts>, .group = FactGroup::kPaper, .screen = {"encoder counts lost"},
     .expectations = {equal<&E::lost_counts>("lost_counts")}},

    // ---- the program
    {.name = "program_end", .unit = "",
     .meaning = "How the program ended, see `program_end` in [KEYS.md](KEYS.md)",
     .value = program_end, .group = FactGroup::kProgram,
     .expectations = {equal<&E::program_end>("program_end")}, .in_words = program_end_text, .where = at_program,
     .otherwise = {{std::string{kProgramEnds.front()}, "ended, as it is not stated"}}},
    {.name = "program_end_line", .unit = "", .meaning = "The line in which it ended. `null`: it did not begin",
     .value = program_end_line, .group = FactGroup::kProgram,
     .expectations = {equal<&E::program_end_line>("program_end_line")}, .where = at_program},
    {.name = "program_messages", .unit = "", .meaning = "Messages of the program to the operator, in the order of time",
     .value = measured<&F::program_messages>, .group = FactGroup::kProgram,
     .expectations = {equal<&E::program_messages>("program_messages")}},

    // ---- serial line and outputs of the tool
    {.name = "serial_sent_hex", .unit = "",
     .meaning = "Bytes that the controller sent on its serial line, as hexadecimal digits",
     .value = serial_sent, .group = FactGroup::kSerial,
     .expectations = {{.key = "serial_text", .wanted = wanted_serial<false>},
                      {.key = "serial_hex", .wanted = wanted_serial<true>}}},
    {.name = "serial_errors", .unit = "", .meaning = "Number of errors in these bytes, and of breaks",
     .value = measured<&F::serial_errors>, .group = FactGroup::kSerial},
    {.name = "outputs", .unit = "", .meaning = "All changes of the outputs of the tool",
     .value = measured<&F::outputs>, .group = FactGroup::kOutputs,
     .expectations = {{.key = "output", .relation = Relation::kWithin, .wanted = wanted_outputs}}},
    {.name = "final_outputs", .unit = "", .meaning = "Outputs of the tool that are high at the end",
     .value = measured<&F::high_outputs>, .group = FactGroup::kOutputs,
     .expectations = {equal<&E::final_outputs>("final_outputs")}},

    // ---- instructions
    {.name = "max_tick_instructions", .unit = "", .meaning = "Most instructions of core 0 in one tick",
     .value = [](const F& facts) -> FactValue { return std::ranges::max(facts.most_instructions); },
     .group = FactGroup::kInstructions, .screen = {"instructions a tick"}, .where = place_of<&F::most_instructions_at>},
    {.name = "max_idle_tick_instructions", .unit = "", .meaning = "The same in the state `idle`",
     .value = most_instructions_in<MotionState::kIdle>, .group = FactGroup::kInstructions},
    {.name = "max_moving_tick_instructions", .unit = "", .meaning = "The same in the state `moving`",
     .value = most_instructions_in<MotionState::kMoving>, .group = FactGroup::kInstructions},
    {.name = "max_stopping_tick_instructions", .unit = "", .meaning = "The same in the state `stopping`",
     .value = most_instructions_in<MotionState::kStopping>, .group = FactGroup::kInstructions},
    {.name = "max_holding_tick_instructions", .unit = "", .meaning = "The same in the state `holding`",
     .value = most_instructions_in<MotionState::kHolding>, .group = FactGroup::kInstructions},
    {.name = "max_fault_tick_instructions", .unit = "", .meaning = "The same in the state `fault`",
     .value = most_instructions_in<MotionState::kFault>, .group = FactGroup::kInstructions},
  };
}
// clang-format on

}  // namespace

const std::vector<Fact>& fact_list() {
  static const std::vector<Fact> kList = make_list();
  return kList;
}

const Fact& fact_named(std::string_view name) {
  const auto found = std::ranges::find(fact_list(), name, &Fact::name);
  assert(found != fact_list().end());
  return *found;
}

}  // namespace armature::cosim
