// [pendant] and [[pendant.step]]: a teach pendant on the serial line.
#include <fmt/format.h>

#include <string>

#include "controller/message/program_noted.hpp"
#include "controller/pendant/protocol/frame_table.hpp"
#include "cosim/programs/program_name.hpp"
#include "cosim/scenario/tables/shared_keys.hpp"
#include "cosim/scenario/tables/tables.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

using pendant::kOpcodeRules;
using pendant::OpcodeRule;

// Without `none`.
Rule message_kinds() {
  Rule rule;
  rule.choices.assign(pendant::kMessageKindNames.begin() + 1, pendant::kMessageKindNames.end());
  return rule;
}

Rule command_names() {
  Rule rule;
  for (const OpcodeRule& one : kOpcodeRules) {
    if (!one.reply_only) rule.choices.push_back(one.name);
  }
  return rule;
}

const OpcodeRule* rule_of(const PendantStepSpec& step) {
  for (const OpcodeRule& one : kOpcodeRules) {
    if (one.name == step.command) return &one;
  }
  return nullptr;
}

std::string check_parameter(const PendantStepSpec& step, const KeyContext&) {
  const OpcodeRule* rule = rule_of(step);
  if (rule == nullptr || (step.parameter >= rule->parameter.min && step.parameter <= rule->parameter.max)) return {};
  return "expected " + std::to_string(rule->parameter.min) + " to " + std::to_string(rule->parameter.max) + " for " +
         step.command + ", found " + std::to_string(step.parameter);
}

std::string check_message(const PendantStepSpec& step, const KeyContext&) {
  if (step.message.size() <= ProgramNoted::kMaxText) return {};
  return fmt::format("expected at most {} characters, found {}", ProgramNoted::kMaxText, step.message.size());
}

std::string check_file(const PendantStepSpec& step, const KeyContext&) {
  if (program_language(step.file) != ProgramLanguage::kNone) return {};
  return fmt::format("expected the name of a file that {}", kEndsLikeProgram);
}

// The step before it that sends a program must have sent a job, too.
std::string check_adds_job(const PendantStepSpec& step, const KeyContext& context) {
  if (!step.adds_job) return {};
  if (program_language(step.file) != ProgramLanguage::kJob) return "allowed only with a .jbi file";
  ProgramLanguage before = ProgramLanguage::kNone;
  for (const PendantStepSpec& other : context.scenario->pendant->steps) {
    if (&other == &step) break;
    if (sends_program(other)) before = program_language(other.file);
  }
  return before == ProgramLanguage::kJob ? std::string{} : "needs a step before it that sends a .jbi file";
}

std::string check_step_time(const PendantStepSpec& step, const KeyContext& context) {
  return outside_run(step.at_s, *context.scenario);
}

}  // namespace

const KeyTable<PendantStepSpec>& pendant_step_keys() {
  constexpr double kLargestPayload = 134'217'727, kLongestMs = 600'000;
  static const std::string kDefaultTimes = fmt::format("{}; with `do` = `download` {}", kWithinMs, kDownloadWithinMs);
  static const Condition kSend = when("do", {"send"}), kJog = when("do", {"jog"}), kMove = when("do", {"move"}),
                         kDownload = when("do", {"download"}), kReadMessage = when("do", {"read_message"});
  static const KeyTable<PendantStepSpec> kTable{
      .text =
          "Each table is one step of the operator. Steps are executed in their order, each when the one before it is "
          "complete. A step that does not succeed in time ends the run as failed.",
      .keys = {
          key("at_s", &PendantStepSpec::at_s, between(0, kMaxDurationS, "s"), "Earliest time at which the step begins.")
              .checked(check_step_time),
          named_key("do", &PendantStepSpec::act,
                    "What the operator does. `send`: sends one command. `wait`: waits for a state of the arm. `jog`: "
                    "keeps the jog key of an axis pressed. `move`: stages a target and moves there. `download`: sends "
                    "a program. `estop`: presses the emergency stop. `read_message`: waits for a message of the "
                    "program, or for its alarm, and reads its text."),
          key("command", &PendantStepSpec::command, command_names(),
              "Name of the command, see `controller/pendant/PROTOCOL.md`.")
              .required()
              .only(kSend),
          key("parameter", &PendantStepSpec::parameter, between(0, 127), "Parameter of the command.")
              .only(kSend)
              .checked(check_parameter),
          key("payload", &PendantStepSpec::payload, between(-kLargestPayload, kLargestPayload),
              "Payload of the command.")
              .only(kSend),
          key("state", &PendantStepSpec::state, one_of(pendant::kStateNames), "State to wait for.")
              .required()
              .only(when("do", {"wait"})),
          key("axis", &PendantStepSpec::axis, between(1, 6), "Joint 1 to 6, or X, Y, Z, Rx, Ry, Rz.")
              .required()
              .only(kJog),
          key("percent", &PendantStepSpec::percent, between(-100, 100, "percent"),
              "Velocity as a share of the speed of jogs.")
              .required()
              .only(kJog),
          key("for_s", &PendantStepSpec::for_s, above(0, kMaxDurationS, "s"), "Time for which the key is pressed.")
              .required()
              .only(kJog),
          key("release", &PendantStepSpec::release, anything(),
              "The pendant sends `jog_stop` at the end. If false, it sends no jog any more, as if the operator had "
              "fallen.")
              .only(kJog),
          key("path", &PendantStepSpec::path, one_of(kPendantPathNames),
              "`joints`: all joints move to the target. `line`: the tool moves there on a straight line. `arc`: on an "
              "arc through `via_mm`.")
              .only(kMove),
          key("joints_deg", &PendantStepSpec::joints_deg, between(-kMaxAngleDeg, kMaxAngleDeg, "deg"),
              "Target in joint coordinates.")
              .required()
              .only(kMove),
          key("xyz_mm", &PendantStepSpec::xyz_mm, between(-kMaxPlaceMm, kMaxPlaceMm, "mm"),
              "Position of the target in the coordinates that `set_coordinates` has selected.")
              .only(kMove)
              .replaces("joints_deg")
              .needs(Needs::kKinematics),
          key("rpy_deg", &PendantStepSpec::rpy_deg, between(-kMaxAngleDeg, kMaxAngleDeg, "deg"),
              "Orientation of the target: rotations about the fixed x, then y, then z axis.")
              .only(beside("xyz_mm")),
          key("via_mm", &PendantStepSpec::via_mm, between(-kMaxPlaceMm, kMaxPlaceMm, "mm"), "Point on the arc.")
              .required()
              .only(when("path", {"arc"})),
          key("speed_percent", &PendantStepSpec::speed_percent, between(0.01, 100, "percent"),
              "Speed as a share of the limits of the joints, or of 250 mm/s and 45 deg/s of the tool.")
              .without("25")
              .only(kMove),
          key("accel_percent", &PendantStepSpec::accel_percent, between(0.01, 100, "percent"),
              "Acceleration as a share of its limits.")
              .without("100")
              .only(kMove),
          key("file", &PendantStepSpec::file, anything(),
              "File of the program, `.jbi`, `.ngc`, `.nc` or `.gcode`, relative to the scenario file. The controller "
              "checks its text.")
              .required()
              .only(kDownload)
              .checked(check_file),
          key("adds_job", &PendantStepSpec::adds_job, anything(),
              "The job becomes a part of the program that the controller has, so that its jobs can be called.")
              .only(kDownload)
              .checked(check_adds_job),
          key("message", &PendantStepSpec::message, anything(),
              "Text to wait for: what the program said last, or the reason of its alarm. At most 64 characters.")
              .without("any text")
              .only(kReadMessage)
              .checked(check_message),
          key("kind", &PendantStepSpec::kind, message_kinds(),
              "What the text is. `stopped` has none: the arm did not carry out a line of the program.")
              .only(kReadMessage),
          key("reply", &PendantStepSpec::reply, one_of(pendant::kStatusNames),
              "Expected status of the reply. A move and a download are several commands: the status of the last one.")
              .only(unless("do", {"wait", "read_message"})),
          key("within_ms", &PendantStepSpec::within_ms, above(0, kLongestMs, "ms"),
              "Longest time from the beginning of the step to the reply, the state or the message.")
              .without(kDefaultTimes),
      }};
  return kTable;
}

const KeyTable<PendantSpec>& pendant_keys() {
  static const KeyTable<PendantSpec> kTable{
      .text =
          "Connects a teach pendant to the serial line of the controller; `controller/pendant/PROTOCOL.md` describes "
          "its protocol. The drives are off until the pendant switches them on. `run --serial` connects another "
          "program instead of the steps.",
      .keys =
          {
              key("profile", &PendantSpec::profile, one_of(kPendantProfileNames),
                  "What the pendant may do while a program runs. `strict`: only an emergency stop, as Vo 2021 has it. "
                  "`extended`: also hold, end and slow down."),
              key("lost_percent", &PendantSpec::lost_percent, between(0, 50, "percent"),
                  "Share of the bytes that the line loses, in each direction."),
              key("flipped_percent", &PendantSpec::flipped_percent, between(0, 50, "percent"),
                  "Share of the bytes in which the line changes one bit, in each direction."),
          },
      .tables = {tables("step", &PendantSpec::steps, pendant_step_keys())}};
  return kTable;
}

}  // namespace armature::cosim
