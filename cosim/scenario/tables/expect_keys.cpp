// [expect]: what must be true of a run.
#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/bus/bus_error.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/scenario/tables/tables.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

constexpr double kMaxSpeedDegS = 100'000;

// All causes except `controller_silent`, which the controller does not report.
Rule seen_by_controller() {
  Rule rule = one_of(kCauses);
  std::erase(rule.choices, kControllerSilent);
  return rule;
}

Rule count(std::string_view unit = {}) {
  return at_least(0, unit);
}
Rule any_count(std::string_view unit) {
  return {.unit = unit};
}
Rule distance() {
  return between(0, kMaxPlaceMm, "mm");
}

// Each pin once, in the order of the measured list.
std::string check_ascending(const ExpectSpec& expect, const KeyContext&) {
  const std::vector<std::int64_t>& pins = *expect.final_outputs;
  if (std::ranges::adjacent_find(pins, std::greater_equal{}) == pins.end()) return {};
  std::string found;
  for (const std::int64_t pin : pins) found += (found.empty() ? "" : ", ") + std::to_string(pin);
  return "expected pins in ascending order, each once, found [" + found + "]";
}

std::string check_elastic(const ExpectSpec&, const KeyContext& context) {
  const RobotSpec* robot = context.robot.spec;
  if (robot == nullptr || robot->plant == kDynamicPlant) return {};
  return "needs a robot with plant = \"" + std::string{kDynamicPlant} + "\", \"" + robot->name + "\" has rigid gears";
}

std::string check_stretch(const ExpectSpec& expect, const KeyContext&) {
  if (!expect.max_stretch || *expect.min_stretch <= *expect.max_stretch) return {};
  return "expected at most max_stretch = " + number_text(*expect.max_stretch) + ", found " +
         number_text(*expect.min_stretch);
}

std::string check_residual(const ExpectSpec& expect, const KeyContext&) {
  if (!expect.max_residual_deg || *expect.min_residual_deg <= *expect.max_residual_deg) return {};
  return "expected at most max_residual_deg = " + number_text(*expect.max_residual_deg) + ", found " +
         number_text(*expect.min_residual_deg);
}

std::string set_serial_text(ExpectSpec& expect, const std::string& bytes) {
  expect.serial_sent = bytes;
  return {};
}

std::string set_serial_hex(ExpectSpec& expect, const std::string& digits) {
  expect.serial_as_hex = true;
  return read_hex(digits, expect.serial_sent.emplace());
}

// For messages about failed expectations.
void note_origins(TableReader& table, const KeyContext&, ExpectSpec& expect) {
  expect.origins = table.origins();
}

}  // namespace

const KeyTable<ExpectSpec>& expect_keys() {
  static const KeyTable<ExpectSpec> kTable{
      .text = "Each key is a check at the end of the run. A run that fails a check is not passed.",
      .keys =
          {
              key("outcome", &ExpectSpec::outcome, one_of(outcomes()),
                  "End of the run: `completed`, or `fault:` and the cause of the fault.")
                  .without("`completed`"),
              key("stopped_by", &ExpectSpec::stopped_by, one_of(kCauses),
                  "Cause of the last drop of the servo enables."),
              key("faults", &ExpectSpec::faults, seen_by_controller(),
                  "All faults that the controller reported, in the order of time. Faults that were cleared count too.")
                  .without("no fault"),
              key("bus_error", &ExpectSpec::bus_error, one_of(kBusErrorNames),
                  "First error response of the bus that stopped a core: to a `stray_write`, or after a `block_hang`. "
                  "Any other error response ends the run as failed.")
                  .without("`none`"),
              key("missing_ticks", &ExpectSpec::missing_ticks, count("ticks"),
                  "Triggers that did not come: the clock of the logic or its timer stood still.")
                  .without("0"),
              key("unanswered_faults", &ExpectSpec::unanswered_faults, count(),
                  "Number of `[[fault]]` to which nothing responded until the next fault or the end of the run. A "
                  "response is: the controller reports a fault, a servo enable drops, a core stops, a tick underruns, "
                  "or the feedback corrects lost pulses. The only response to an `estop` is that all servo enables "
                  "drop. A fault that comes while all servo enables are low needs no response.")
                  .without("0"),
              key("max_stop_ticks", &ExpectSpec::max_stop_ticks, count("ticks"),
                  "Largest allowed time from the begin of a `[[fault]]` until a servo enable drops. A fault does not "
                  "count if the next one begins first, or if no enable drops. If no fault counts, the check fails."),
              key("unasked_stops", &ExpectSpec::unasked_stops, count(),
                  "Number of stops that nobody asked for: the tool came to rest between two paths of a chain, because "
                  "the controller had the second one before the tool began to brake, but had no plan that continues "
                  "the motion in time. Stops for any other reason do not count.")
                  .without("0"),
              key("final_joint_deg", &ExpectSpec::final_joint_deg, between(-kMaxAngleDeg, kMaxAngleDeg, "deg"),
                  "Joint angles at the end, by the encoders."),
              key("tolerance_deg", &ExpectSpec::tolerance_deg, between(0, kMaxAngleDeg, "deg"),
                  "Tolerance of `final_joint_deg`.")
                  .only(beside("final_joint_deg")),
              key("final_load_deg", &ExpectSpec::final_load_deg, between(-kMaxAngleDeg, kMaxAngleDeg, "deg"),
                  "True joint angles at the end, behind the gears, of a robot with `plant = \"dynamic\"`.")
                  .checked(check_elastic),
              key("load_tolerance_deg", &ExpectSpec::load_tolerance_deg, between(0, kMaxAngleDeg, "deg"),
                  "Tolerance of `final_load_deg`.")
                  .only(beside("final_load_deg")),
              key("lost_motion_deg", &ExpectSpec::lost_motion_deg, between(0, kMaxAngleDeg, "deg"),
                  "By how much each joint moved relative to its motor in the run, with `plant = \"dynamic\"`. This is "
                  "the play and the twist of its gear.")
                  .checked(check_elastic),
              key("lost_motion_tolerance_deg", &ExpectSpec::lost_motion_tolerance_deg, between(0, kMaxAngleDeg, "deg"),
                  "Tolerance of `lost_motion_deg`.")
                  .only(beside("lost_motion_deg")),
              key("total_pulses", &ExpectSpec::total_pulses, any_count("pulses"),
                  "Net pulses of each axis, counted on the pins."),
              key("peak_pulses_per_tick", &ExpectSpec::peak_pulses_per_tick, count("pulses"),
                  "Largest number of pulses of any axis in one tick."),
              key("move_ticks", &ExpectSpec::move_ticks, count("ticks"),
                  "Planned duration of each move. Each path of a blended chain is one move."),
              key("taken_ticks", &ExpectSpec::taken_ticks, count("ticks"),
                  "Duration of each move that reached its end, with the time for holds and overrides. Moves that a "
                  "stop or a fault cut short are not listed."),
              key("profile", &ExpectSpec::profile, one_of(kWordsOf<ProfileShape>),
                  "Shape of the speed of each joint in the first move.")
                  .per_axis(),
              key("peak_speed_deg_s", &ExpectSpec::peak_speed_deg_s, between(0, kMaxSpeedDegS, "deg/s"),
                  "Largest commanded speed of each joint."),
              key("peak_tolerance_deg_s", &ExpectSpec::peak_tolerance_deg_s, between(0, kMaxSpeedDegS, "deg/s"),
                  "Tolerance of `peak_speed_deg_s`.")
                  .only(beside("peak_speed_deg_s")),
              key("settled_within_s", &ExpectSpec::settled_within_s, between(0, 86'400, "s"),
                  "Settling time: this time after the last motion of the set-points, all encoders stay within "
                  "`settled_counts` of the reference."),
              key("settled_counts", &ExpectSpec::settled_counts, count("counts"),
                  "Distance from the reference that counts as settled.")
                  .only(beside("settled_within_s")),
              key("max_overshoot_counts", &ExpectSpec::max_overshoot_counts, count("counts"),
                  "Largest allowed overshoot of any encoder beyond its final reference."),
              key("final_error_counts", &ExpectSpec::final_error_counts, any_count("counts"),
                  "Reference minus encoder of each axis at the end."),
              key("max_correction_pulses", &ExpectSpec::max_correction_pulses, count("pulses"),
                  "Largest allowed correction by the feedback."),
              key("underruns", &ExpectSpec::underruns, count("ticks"),
                  "Number of ticks whose pulse counts came too late for the logic.")
                  .without("0"),
              key("min_underruns", &ExpectSpec::min_underruns, count("ticks"), "Least number of underruns.")
                  .replaces("underruns"),
              key("inexact_ticks", &ExpectSpec::inexact_ticks, count("ticks"),
                  "Number of ticks, for each axis, that emitted another count than the controller intended.")
                  .needs(Needs::kPaper),
              key("max_residual_pulses", &ExpectSpec::max_residual_pulses, count("pulses"),
                  "Largest difference between the intended and the emitted count. The next ticks compensate it.")
                  .needs(Needs::kPaper),
              key("lost_counts", &ExpectSpec::lost_counts, any_count("counts"),
                  "Net counts of each motor that the controller did not see: its true position minus the position that "
                  "the controller knows."),
              key("refused_moves", &ExpectSpec::refused_moves, count(),
                  "Number of moves that the controller refused or dropped.")
                  .without("0"),
              key("refusals", &ExpectSpec::refusals, one_of(kWordsOf<Refusal>),
                  "Reasons of all refused and dropped moves, in the order of time. That order may differ from the "
                  "order of the file."),
              key("jog_ends", &ExpectSpec::jog_ends, one_of(kWordsOf<JogEnd>),
                  "Why each jog ended, in the order of time. `duration`: the time of its only command had passed. "
                  "`time_out`: it had several commands, and the time of the last one had passed. `released`: the last "
                  "command had no velocity. `limit`: a joint stood at its soft limit. `cannot_follow`: the joints "
                  "could "
                  "not move the tool on."),
              key("homing_ends", &ExpectSpec::homing_ends, one_of(kWordsOf<HomingEnd>),
                  "How the homing of each axis ended, in the order of time. `homed`: the angle is known, and the axis "
                  "stands at its home position. `no_switch`: no home switch within the travel. `switch_stuck`: the "
                  "home switch stayed active. `no_index`: no index pulse within a turn of the motor. `index_at_edge`: "
                  "the index pulse is within 2 % of a turn of the edge of the switch, so another run could find the "
                  "next one. `limit`: a limit switch where none is expected. `stop`: by a stop or a hold, or because "
                  "another axis failed."),
              key("streams", &ExpectSpec::streams, one_of(kWordsOf<StreamEnded::How>),
                  "How each stream ended, in the order of time. `complete`: at its last set-point. `late`: the next "
                  "set-point was not there in time. `stopped`: by a stop, a hold or a refused set-point."),
              key("max_stream_deviation_deg", &ExpectSpec::max_stream_deviation_deg, between(0, kMaxAngleDeg, "deg"),
                  "Largest allowed distance of the set-points of any axis from the streams, with their delay."),
              key("conveyor_ends", &ExpectSpec::conveyor_ends, one_of(kWordsOf<PartEnd>),
                  "Why the arm stopped following each part, in the order of time. `released`: the next move is in "
                  "another frame. `window`: the part left the window. `too_fast`: the belt was too fast. "
                  "`cannot_follow`: the joints could not follow. `unseen`: the camera had no new sample. `stopped`: "
                  "by a stop or a hold."),
              key("min_solved_poses", &ExpectSpec::min_solved_poses, count(),
                  "Least number of set-points whose joint angles are those of the block `ik_cordic`, see "
                  "`[kinematics]`."),
              key("max_solver_difference_pulses", &ExpectSpec::max_solver_difference_pulses, at_least(0, "pulses"),
                  "Largest allowed difference of such a joint angle from software."),
              key("missed_parts", &ExpectSpec::missed_parts, count(),
                  "Number of parts that had passed the window before a move waited for them."),
              key("max_tracking_error_mm", &ExpectSpec::max_tracking_error_mm, distance(),
                  "Largest allowed distance of the tool centre point, by the encoders, from its paths on the moving "
                  "part. It is measured against the true motion of the belt until the arm leaves the part. It begins "
                  "when the drives have settled after the synchronisation: 65 ms with a position loop of 40 Hz.")
                  .needs(Needs::kKinematics),
              key("max_command_tracking_error_mm", &ExpectSpec::max_command_tracking_error_mm, distance(),
                  "The same of the set-points. It begins when the arm is synchronised with the part.")
                  .needs(Needs::kKinematics),
              key("min_corrected_ticks", &ExpectSpec::min_corrected_ticks, count(),
                  "Least number of ticks in which the network of `[conveyor.policy]` corrected where the belt is "
                  "expected. A tick counts from the time on at which the arm waits for a part."),
              key("max_corrected_ticks", &ExpectSpec::max_corrected_ticks, count(),
                  "Largest allowed number of such ticks: 0 says that the network never had an effect."),
              key("min_uncorrected_ticks", &ExpectSpec::min_uncorrected_ticks, count(),
                  "Least number of ticks without a correction, see `max_uncorrected_ticks`."),
              key("max_uncorrected_ticks", &ExpectSpec::max_uncorrected_ticks, count(),
                  "Largest allowed number of such ticks without a correction: the belt was outside the ranges of "
                  "training, the network was not the one of its checksum, or the logic was late."),
              key("unfinished_moves", &ExpectSpec::unfinished_moves, count(),
                  "Number of moves that still wait or move when the run ends. A move that a stop or a fault cut short "
                  "has ended.")
                  .without("0"),
              key("blended_moves", &ExpectSpec::blended_moves, count(),
                  "Number of moves that began without a stop after the move before."),
              key("min_held_s", &ExpectSpec::min_held_s, between(0, 86'400, "s"),
                  "Least total time for which a hold stopped the set-points."),
              key("max_path_error_mm", &ExpectSpec::max_path_error_mm, distance(),
                  "Largest allowed distance of the tool centre point, by the encoders, from the nearest path of its "
                  "chain with unrounded corners. After a joint move the check begins when the drives have settled, "
                  "which takes 65 ms with a position loop of 40 Hz.")
                  .needs(Needs::kKinematics),
              key("max_command_path_error_mm", &ExpectSpec::max_command_path_error_mm, distance(),
                  "Largest allowed distance of the set-points from their path, from the first set-point on.")
                  .needs(Needs::kKinematics),
              key("max_tool_speed_mm_s", &ExpectSpec::max_tool_speed_mm_s, at_least(0, "mm/s"),
                  "Largest allowed speed of the tool centre point in the base frame, by the set-points of two "
                  "consecutive ticks. Rounded corners with a joint move count, too: `speed_mm_s` does not apply there.")
                  .needs(Needs::kKinematics),
              key("max_tool_accel_mm_s2", &ExpectSpec::max_tool_accel_mm_s2, at_least(0, "mm/s^2"),
                  "Largest allowed acceleration of the tool centre point, by the set-points of three consecutive "
                  "ticks.")
                  .needs(Needs::kKinematics),
              key("final_tcp_mm", &ExpectSpec::final_tcp_mm, between(-kMaxPlaceMm, kMaxPlaceMm, "mm"),
                  "Position of the tool centre point in the base frame at the end, by the encoders.")
                  .needs(Needs::kKinematics),
              key("tcp_tolerance_mm", &ExpectSpec::tcp_tolerance_mm, distance(),
                  "Tolerance of `final_tcp_mm`, as a distance.")
                  .only(beside("final_tcp_mm")),
              key("final_rpy_deg", &ExpectSpec::final_rpy_deg, between(-kMaxAngleDeg, kMaxAngleDeg, "deg"),
                  "Orientation of the tool in the base frame at the end, by the encoders: rotations about the fixed x, "
                  "then y, then z axis.")
                  .needs(Needs::kKinematics),
              key("rpy_tolerance_deg", &ExpectSpec::rpy_tolerance_deg, between(0, 180, "deg"),
                  "Tolerance of `final_rpy_deg`, as the angle between the two orientations.")
                  .only(beside("final_rpy_deg")),
              key("max_stretch", &ExpectSpec::max_stretch, at_least(1),
                  "Largest allowed factor by which a path is slowed down for its joints. 1 means that no path is "
                  "slowed down."),
              key("min_stretch", &ExpectSpec::min_stretch, at_least(1),
                  "At least one path is slowed down for its joints by this factor or more.")
                  .checked(check_stretch),
              key("max_residual_deg", &ExpectSpec::max_residual_deg, between(0, 180, "deg"),
                  "Largest allowed angle by which the planned orientation of the tool leaves what a move requested: at "
                  "a wrist singularity with `singularity = \"bend\"`, and on five-axis arms."),
              key("min_residual_deg", &ExpectSpec::min_residual_deg, between(0, 180, "deg"),
                  "The orientation leaves what at least one move requested by this angle or more.")
                  .checked(check_residual),
              set_key<ExpectSpec, std::string>("serial_text", set_serial_text, anything(),
                                               "All bytes that the controller sends on the serial line. An error in a "
                                               "byte or a break fails the check.")
                  .needs(Needs::kSerial),
              set_key<ExpectSpec, std::string>("serial_hex", set_serial_hex, anything(),
                                               "The same as `serial_text`, as hexadecimal digits such as \"48 69 0d\".")
                  .needs(Needs::kSerial)
                  .replaces("serial_text")
                  .pattern(kHexPattern),
              key("final_outputs", &ExpectSpec::final_outputs, between(1, kToolPins),
                  "Outputs of the tool that are high at the end, in ascending order, each once.")
                  .checked(check_ascending),
              key("program_end", &ExpectSpec::program_end, one_of(kProgramEnds),
                  "How the program ended. `ended`: all lines were executed, and the arm stands. `alarm`: it could not "
                  "continue. `stopped`: the arm did not carry out one of its commands, or not to the end. `aborted`: "
                  "the operator ended it. `paused`, `held`: it waits for the operator. `running`, `waiting`: the run "
                  "ended "
                  "before it, or before its start.")
                  .without("`ended`")
                  .needs(Needs::kProgram),
              key("program_end_line", &ExpectSpec::program_end_line, at_least(1), "Line in which it ended.")
                  .needs(Needs::kProgram),
              key("program_messages", &ExpectSpec::program_messages, anything(),
                  "All messages of the program to the operator, in their order.")
                  .needs(Needs::kProgram),
          },
      .tables = {tables("output", &ExpectSpec::outputs, expected_output_keys())},
      .checks = {{{}, note_origins}}};
  return kTable;
}

}  // namespace armature::cosim
