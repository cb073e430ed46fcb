// [expect]: what must be true of a run.
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/scenario/tables/tables.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

constexpr double kMaxSpeedDegS = 100'000;

// All causes but that of a controller that notices none.
Rule seen_by_controller() {
  Rule rule = one_of(kCauseNames);
  std::erase(rule.choices, cause_of(kControllerSilent));
  return rule;
}

Rule count() {
  return at_least(0);
}
Rule distance() {
  return between(0, kMaxPlaceMm, "mm");
}

// Each pin once, in the order in which the run's are listed.
std::string check_ascending(const ExpectSpec& expect, const KeyContext&) {
  const std::vector<std::int64_t>& pins = *expect.final_outputs;
  if (std::ranges::adjacent_find(pins, std::greater_equal{}) == pins.end()) return {};
  std::string found;
  for (const std::int64_t pin : pins) found += (found.empty() ? "" : ", ") + std::to_string(pin);
  return "expected pins in ascending order, each once, found [" + found + "]";
}

std::string check_stretch(const ExpectSpec& expect, const KeyContext&) {
  if (!expect.max_stretch || *expect.min_stretch <= *expect.max_stretch) return {};
  return "expected at most max_stretch = " + number_text(*expect.max_stretch) + ", found " +
         number_text(*expect.min_stretch);
}

std::string set_serial_text(ExpectSpec& expect, const std::string& bytes) {
  expect.serial_sent = bytes;
  return {};
}

std::string set_serial_hex(ExpectSpec& expect, const std::string& digits) {
  expect.serial_as_hex = true;
  return read_hex(digits, expect.serial_sent.emplace());
}

// For messages about a missed expectation.
void note_origins(TableReader& table, const KeyContext&, ExpectSpec& expect) {
  expect.origins = table.origins();
}

}  // namespace

const KeyTable<ExpectSpec>& expect_keys() {
  static const KeyTable<ExpectSpec> kTable{
      .text = "Each key is a check at the end of the run.",
      .keys =
          {
              key("outcome", &ExpectSpec::outcome, one_of(kOutcomeNames),
                  "How the run ends: `completed`, or `fault:` and the cause of the fault.")
                  .without("`completed`"),
              key("stopped_by", &ExpectSpec::stopped_by, one_of(kCauseNames),
                  "The cause that dropped the servo enables last."),
              key("faults", &ExpectSpec::faults, seen_by_controller(),
                  "All faults that the controller saw, in their order, also those that were cleared again.")
                  .without("no fault"),
              key("final_joint_deg", &ExpectSpec::final_joint_deg, between(-kMaxAngleDeg, kMaxAngleDeg, "deg"),
                  "The encoders show these joint angles at the end."),
              key("tolerance_deg", &ExpectSpec::tolerance_deg, between(0, kMaxAngleDeg, "deg"),
                  "`final_joint_deg` may differ by this much.")
                  .only(beside("final_joint_deg")),
              key("total_pulses", &ExpectSpec::total_pulses, anything(),
                  "The net pulses of each axis, counted on the pins."),
              key("peak_pulses_per_tick", &ExpectSpec::peak_pulses_per_tick, count(),
                  "The largest number of pulses of an axis in one tick."),
              key("move_ticks", &ExpectSpec::move_ticks, count(),
                  "The planned duration of each move in ticks. Each path of a blended chain is a move."),
              key("taken_ticks", &ExpectSpec::taken_ticks, count(),
                  "The ticks that each move took which reached its end: its planned duration, holds, overrides, and "
                  "braking "
                  "for them. A move that a stop or a fault cut short is left out."),
              key("profile", &ExpectSpec::profile, one_of(kShapeNames), "The shapes of the joints in the first move.")
                  .per_axis(),
              key("peak_speed_deg_s", &ExpectSpec::peak_speed_deg_s, between(0, kMaxSpeedDegS, "deg/s"),
                  "The largest commanded speed of each joint."),
              key("peak_tolerance_deg_s", &ExpectSpec::peak_tolerance_deg_s, between(0, kMaxSpeedDegS, "deg/s"),
                  "`peak_speed_deg_s` may differ by this much.")
                  .only(beside("peak_speed_deg_s")),
              key("settled_within_s", &ExpectSpec::settled_within_s, between(0, 86'400, "s"),
                  "The encoders stay close to the reference from this time after the last motion on."),
              key("settled_counts", &ExpectSpec::settled_counts, count(),
                  "Encoders within so many counts are close enough for `settled_within_s`.")
                  .only(beside("settled_within_s")),
              key("max_overshoot_counts", &ExpectSpec::max_overshoot_counts, count(),
                  "No encoder passes its final reference by more counts."),
              key("final_error_counts", &ExpectSpec::final_error_counts, anything(),
                  "The reference minus the encoder of each axis at the end, in counts."),
              key("max_correction_pulses", &ExpectSpec::max_correction_pulses, count(),
                  "No correction by the feedback is larger."),
              key("underruns", &ExpectSpec::underruns, count(), "The number of ticks without a command for the logic.")
                  .without("0"),
              key("min_underruns", &ExpectSpec::min_underruns, count(), "There are at least so many underruns.")
                  .replaces("underruns"),
              key("inexact_ticks", &ExpectSpec::inexact_ticks, count(),
                  "The ticks in which each axis emitted another count than it was meant to.")
                  .needs(Needs::kPaper),
              key("max_residual_pulses", &ExpectSpec::max_residual_pulses, count(),
                  "The largest difference between the count that was meant and the count that was emitted. The next "
                  "ticks "
                  "make up for it.")
                  .needs(Needs::kPaper),
              key("lost_counts", &ExpectSpec::lost_counts, anything(),
                  "The net counts that each motor moved and the controller never saw.")
                  .needs(Needs::kPaper),
              key("refused_moves", &ExpectSpec::refused_moves, count(),
                  "The number of moves that the controller refused or dropped.")
                  .without("0"),
              key("refusals", &ExpectSpec::refusals, one_of(kRefusalNames),
                  "The reasons of all refused and dropped moves, in the order in which they are reported. That order "
                  "need not "
                  "be the order of the file."),
              key("unfinished_moves", &ExpectSpec::unfinished_moves, count(),
                  "The number of moves that are neither refused nor at their end when the run ends. A move that a stop "
                  "or a "
                  "fault cut short has ended.")
                  .without("0"),
              key("blended_moves", &ExpectSpec::blended_moves, count(),
                  "The number of moves that began in the corner to the move before."),
              key("min_held_s", &ExpectSpec::min_held_s, between(0, 86'400, "s"),
                  "The set-points stood in a hold for at least this time in total."),
              key("max_path_error_mm", &ExpectSpec::max_path_error_mm, distance(),
                  "The encoders show the tool centre point within this distance of the nearest path of its chain, "
                  "whose "
                  "corners are not rounded. Right after a joint move the check begins when the drives have settled, 65 "
                  "ms "
                  "with a position loop of 40 Hz.")
                  .needs(Needs::kKinematics),
              key("max_command_path_error_mm", &ExpectSpec::max_command_path_error_mm, distance(),
                  "The same for the set-points, from the first one on.")
                  .needs(Needs::kKinematics),
              key("final_tcp_mm", &ExpectSpec::final_tcp_mm, between(-kMaxPlaceMm, kMaxPlaceMm, "mm"),
                  "The encoders show the tool centre point here in the base frame at the end.")
                  .needs(Needs::kKinematics),
              key("tcp_tolerance_mm", &ExpectSpec::tcp_tolerance_mm, distance(), "`final_tcp_mm` may be this far away.")
                  .only(beside("final_tcp_mm")),
              key("final_rpy_deg", &ExpectSpec::final_rpy_deg, between(-kMaxAngleDeg, kMaxAngleDeg, "deg"),
                  "The encoders show this orientation of the tool at the end.")
                  .needs(Needs::kKinematics),
              key("rpy_tolerance_deg", &ExpectSpec::rpy_tolerance_deg, between(0, 180, "deg"),
                  "The angle between `final_rpy_deg` and the orientation may be this large.")
                  .only(beside("final_rpy_deg")),
              key("max_stretch", &ExpectSpec::max_stretch, at_least(1),
                  "No path is slowed down for its joints by a larger factor. 1 means that none is."),
              key("min_stretch", &ExpectSpec::min_stretch, at_least(1),
                  "At least one path is slowed down for its joints by this factor.")
                  .checked(check_stretch),
              set_key<ExpectSpec, std::string>("serial_text", set_serial_text, anything(),
                                               "All bytes that the controller sends on the serial line. No byte has an "
                                               "error, and there is no break.")
                  .needs(Needs::kSerial),
              set_key<ExpectSpec, std::string>("serial_hex", set_serial_hex, anything(),
                                               "The same as `serial_text`, in hexadecimal digits such as \"48 69 0d\".")
                  .needs(Needs::kSerial)
                  .replaces("serial_text")
                  .pattern(kHexPattern),
              key("final_outputs", &ExpectSpec::final_outputs, between(1, kToolPins),
                  "The outputs of the tool that are high at the end, in ascending order, each once.")
                  .checked(check_ascending),
          },
      .tables = {tables("output", &ExpectSpec::outputs, expected_output_keys())},
      .checks = {{{}, note_origins}}};
  return kTable;
}

}  // namespace armature::cosim
