#include "cosim/live/page_commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "controller/base/angle_units.hpp"
#include "cosim/live/live_faults.hpp"
#include "cosim/pendant/step_frames.hpp"
#include "cosim/programs/program_name.hpp"

namespace armature::cosim {
namespace {

using pendant::Frame;
using pendant::Opcode;

constexpr double kLargestDeg = 3'600, kLargest_mm = 100'000;  // as pulses and um they are numbers of 32 bits
constexpr std::size_t kMaxProgram = 262'144;                  // characters, as PROTOCOL.md says
constexpr std::size_t kMaxName = 200;
constexpr std::int64_t kMaxLine = 65'535;
constexpr std::array<std::string_view, 4> kSystems{"joints", "base", "tool", "user"};

const pendant::OpcodeRule& rule_of(const PageMessage& message) {
  const std::string name = message.text("command", kMaxName);
  const auto rule = std::ranges::find(pendant::kOpcodeRules, name, &pendant::OpcodeRule::name);
  if (rule == pendant::kOpcodeRules.end() || rule->reply_only) {
    throw MessageError{fmt::format("send: there is no command \"{}\"", name)};
  }
  return *rule;
}

// The pendant itself sends these: the page would disturb it.
bool is_of_the_link(Opcode opcode) {
  return opcode == Opcode::kHeartbeat || opcode == Opcode::kSetTelemetry || opcode == Opcode::kJogContinuous ||
         opcode == Opcode::kProgramBegin || opcode == Opcode::kProgramCommit;
}

}  // namespace

std::string PageCommands::answer(std::string_view text) try {
  const Json json = execute(PageMessage{text});
  return json.is_null() ? std::string{} : json.dump();
} catch (const MessageError& error) {
  return Json{{"error", error.what()}}.dump(-1, ' ', true, Json::error_handler_t::replace);
}

Json PageCommands::execute(const PageMessage& message) {
  using Act = void (PageCommands::*)(const PageMessage&);
  using Question = Json (PageCommands::*)(const PageMessage&) const;
  static constexpr std::array kActs{std::pair<std::string_view, Act>{"jog", &PageCommands::jog},
                                    std::pair<std::string_view, Act>{"send", &PageCommands::send},
                                    std::pair<std::string_view, Act>{"move", &PageCommands::move},
                                    std::pair<std::string_view, Act>{"load", &PageCommands::load},
                                    std::pair<std::string_view, Act>{"run", &PageCommands::run},
                                    std::pair<std::string_view, Act>{"breakpoint", &PageCommands::breakpoint},
                                    std::pair<std::string_view, Act>{"fault", &PageCommands::fault},
                                    std::pair<std::string_view, Act>{"input", &PageCommands::input},
                                    std::pair<std::string_view, Act>{"hold", &PageCommands::hold}};
  static constexpr std::array kQuestions{std::pair<std::string_view, Question>{"forward", &PageCommands::forward},
                                         std::pair<std::string_view, Question>{"inverse", &PageCommands::inverse}};
  const std::string& what = message.what();
  if (what == "beat") return nullptr;  // that it came is all
  if (what == "release") return pendant_.release_jog(), nullptr;
  if (what == "estop") return pendant_.link().press_estop(), nullptr;
  for (const auto& [name, act] : kActs) {
    if (what == name) return (this->*act)(message), nullptr;
  }
  for (const auto& [name, question] : kQuestions) {
    if (what == name) return (this->*question)(message);
  }
  throw MessageError{fmt::format(
      "\"do\" is beat, release, estop, jog, send, move, load, run, breakpoint, fault, input, hold, forward or "
      "inverse, not \"{}\"",
      what)};
}

void PageCommands::press(const Frame& frame) {
  if (!pendant_.press(frame)) {
    throw MessageError{pendant_.link().connected() ? "too many commands wait for the controller"
                                                   : "the controller does not answer yet"};
  }
}

void PageCommands::jog(const PageMessage& message) {
  constexpr double kFull = 10'000;  // 0.01 %
  const auto system = static_cast<pendant::System>(message.integer("system", 0, kSystems.size() - 1));
  const auto axis = message.integer("axis", 0, kAxes - 1);
  const double percent = message.number("percent", -100, 100);
  pendant_.jog(system, static_cast<std::uint8_t>(axis), static_cast<std::int32_t>(std::lround(percent / 100 * kFull)));
}

void PageCommands::send(const PageMessage& message) {
  const pendant::OpcodeRule& rule = rule_of(message);
  if (is_of_the_link(rule.opcode)) {
    throw MessageError{fmt::format("send: the pendant sends \"{}\" by itself", rule.name)};
  }
  const auto parameter = message.integer("parameter", rule.parameter.min, rule.parameter.max);
  const auto payload = message.integer("payload", rule.payload.min, rule.payload.max);
  press({.opcode = rule.opcode,
         .parameter = static_cast<std::uint8_t>(parameter),
         .payload = static_cast<std::int32_t>(payload)});
}

// As the step `move` of a scenario: the coordinates of the target, its speed, then the move.
void PageCommands::move(const PageMessage& message) {
  PendantStepSpec step;
  step.act = PendantAct::kMove;
  step.path = message.text("path", kMaxName);
  if (std::ranges::find(kPendantPathNames, step.path) == kPendantPathNames.end()) {
    throw MessageError{"move: \"path\" is joints, line or arc"};
  }
  pendant::System system = pendant::System::kJoints;
  const bool arc = step.path == "arc";
  if (arc) std::ranges::copy(message.numbers("via_mm", 3, kLargest_mm), step.via_mm.emplace().begin());
  if (!arc && message.has("joints_deg")) {
    const std::vector<double> deg = message.numbers("joints_deg", scenario_.robot.axis_count, kLargestDeg);
    std::ranges::copy(deg, step.joints_deg.emplace().begin());
  } else {
    system = pendant::System::kBase;
    std::ranges::copy(message.numbers("xyz_mm", 3, kLargest_mm), step.xyz_mm.emplace().begin());
    std::ranges::copy(message.numbers("rpy_deg", 3, kLargestDeg), step.rpy_deg.begin());
  }
  constexpr double kSlowest = 0.01;
  step.speed_percent = message.number("speed_percent", kSlowest, 100);
  const std::vector<Frame> frames = frames_of(step, scenario_.robot);
  const auto too_large = [](const Frame& frame) { return std::abs(frame.payload) > pendant::kLargestPayload; };
  if (std::ranges::any_of(frames, too_large)) throw MessageError{"move: the target is too far away"};
  if (pendant_.link().room() <= frames.size()) throw MessageError{"move: too many commands wait for the controller"};
  press({.opcode = Opcode::kSetCoordinates, .parameter = static_cast<std::uint8_t>(system)});
  for (const Frame& frame : frames) press(frame);
}

void PageCommands::load(const PageMessage& message) {
  const std::string name = message.text("name", kMaxName);
  const std::string text = message.text("text", kMaxProgram);
  const ProgramLanguage language = program_language(name);
  if (language == ProgramLanguage::kNone) {
    throw MessageError{fmt::format("load: expected a file that {}", kEndsLikeProgram)};
  }
  const bool ascii = std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80U; });
  if (text.empty() || !ascii) throw MessageError{"load: the program is empty, or has a character that is not ASCII"};
  gcode_ = language == ProgramLanguage::kGcode;
  const pendant::Content kind = gcode_ ? pendant::Content::kGcode : pendant::Content::kJob;
  if (!pendant_.has_operator() || !pendant_.link().download(kind, name, text)) {
    throw MessageError{"load: another program is being sent, or the controller does not answer yet"};
  }
  program_ = name;
}

std::size_t PageCommands::job_of_program() const {
  const std::optional<std::size_t> job = pendant_.link().job_of(program_);
  if (!job) throw MessageError{"load the program first"};
  return *job;
}

void PageCommands::run(const PageMessage& message) {
  const auto mode = message.integer("mode", 0, 2);
  const auto line = message.integer("line", 0, kMaxLine);
  if (!program_.empty()) {
    const std::size_t job = job_of_program();
    if (!gcode_) press({.opcode = Opcode::kProgramSelect, .parameter = static_cast<std::uint8_t>(job)});
  }
  press({.opcode = Opcode::kRun,
         .parameter = static_cast<std::uint8_t>(mode),
         .payload = static_cast<std::int32_t>(line)});
}

void PageCommands::breakpoint(const PageMessage& message) {
  using pendant::BreakpointAction;
  const auto line = static_cast<std::int32_t>(message.integer("line", 1, kMaxLine));
  const auto job = static_cast<std::int32_t>(job_of_program());
  const std::int32_t place = gcode_ ? line : pendant::kLineJob.with(job) | line;
  const auto action = pendant_.link().has_breakpoint(place) ? BreakpointAction::kRemove : BreakpointAction::kSet;
  press({.opcode = Opcode::kSetBreakpoint, .parameter = static_cast<std::uint8_t>(action), .payload = place});
}

void PageCommands::fault(const PageMessage& message) {
  cell_.cause(read_fault(message.table("fault"), scenario_, run_.now()));
}

void PageCommands::input(const PageMessage& message) {
  cell_.click_input(message.integer("pin", 1, kToolPins));
}

void PageCommands::hold(const PageMessage& message) {
  const std::string which = message.text("which", kMaxName);
  if (which == "estop") return cell_.click_estop();
  const std::optional<AxisSwitch> found = enumerator_of<AxisSwitch>(which);
  if (!found) throw MessageError{"hold: \"which\" is home, limit_pos, limit_neg or estop"};
  const auto axis = message.integer("axis", 1, static_cast<std::int64_t>(scenario_.robot.axis_count));
  cell_.click_switch(static_cast<int>(axis), *found);
}

JointAngles PageCommands::joints(const PageMessage& message, const char* key) const {
  JointAngles angles{};
  const std::vector<double> deg = message.numbers(key, scenario_.robot.axis_count, kLargestDeg);
  for (std::size_t i = 0; i < deg.size(); ++i) angles[i] = Radians{deg[i] * kRadPerDeg};
  return angles;
}

Json PageCommands::forward(const PageMessage& message) const {
  if (!kinematics_.known()) throw MessageError{"the robot file has no [kinematics]"};
  return {{"forward", kinematics_.forward(joints(message, "joints_deg"))}};
}

Json PageCommands::inverse(const PageMessage& message) const {
  if (!kinematics_.known()) throw MessageError{"the robot file has no [kinematics]"};
  const auto vector = [&message](const char* key, double largest) {
    const std::vector<double> values = message.numbers(key, 3, largest);
    return Eigen::Vector3d{values[0], values[1], values[2]};
  };
  LiveKinematics::Wish wish{.xyz_mm = vector("xyz_mm", kLargest_mm), .from = joints(message, "from_deg")};
  if (message.has("rpy_deg")) wish.rpy_deg = vector("rpy_deg", kLargestDeg);
  return {{"inverse", kinematics_.inverse(wish)}};
}

}  // namespace armature::cosim
