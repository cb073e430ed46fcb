#include "cosim/pendant/screen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "controller/message/fault.hpp"
#include "cosim/text/names.hpp"

namespace armature::cosim {
namespace {

using pendant::Page;
using pendant::State;
using Style = TerminalLine::Style;

constexpr std::array<std::string_view, 4> kCoordinates{"joints", "base", "tool", "user frame"};
constexpr std::array<std::string_view, 6> kToolNames{"X", "Y", "Z", "Rx", "Ry", "Rz"};
constexpr std::array<std::string_view, 6> kToolUnits{"mm", "mm", "mm", "deg", "deg", "deg"};
constexpr std::size_t kMessageLines = 2;
constexpr std::size_t kKeyColumns = 3;

std::string upper(std::string_view text) {
  std::string result{text};
  for (char& c : result) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return result;
}

TerminalLine status_line(const OperatorLink& link) {
  if (link.estop_pressed()) return {"EMERGENCY STOP IS BEING SENT", Style::kAlarm};
  if (!link.connected()) return {"no connection: waiting for the controller", Style::kAlarm};
  const std::optional<State> state = link.state();
  if (!state) return {"connected, no telemetry yet", Style::kDim};
  const std::string name = upper(pendant::kStateNames[static_cast<std::size_t>(*state)]);
  const bool bad = *state == State::kAlarm || *state == State::kEstop;
  const auto program = static_cast<std::size_t>(link.page(Page::kProgram));
  return {fmt::format("{:<8} drives {:<4} profile {:<9} program {}", name, link.drives_on() ? "on" : "off",
                      link.extended() ? "extended" : "strict",
                      program < pendant::kProgramNames.size() ? pendant::kProgramNames[program] : "?"),
          bad ? Style::kAlarm : Style::kPlain};
}

// In words: `alarm: drive alarm, axis 3`.
TerminalLine alarm_line(const OperatorLink& link) {
  const std::int32_t alarm = link.page(Page::kAlarm);
  if (alarm == 0) return {"no alarm", Style::kDim};
  std::string cause{word_of(static_cast<FaultCause>(pendant::kAlarmCause.of(alarm)))};
  std::ranges::replace(cause, '_', ' ');
  const int axis = pendant::kAlarmAxis.of(alarm);
  return {fmt::format("alarm: {}{}", cause, axis == 0 ? std::string{} : fmt::format(", axis {}", axis)), Style::kAlarm};
}

// What the program said last: `line 12 of job 2 message: "turn the part"`.
TerminalLine message_line(const OperatorDesk& desk) {
  using pendant::MessageKind;
  const std::optional<PendantMessage>& message = desk.link().program_message();
  if (!message || message->header.kind == MessageKind::kNone) return {"no message", Style::kDim};
  const bool gcode = desk.program() != nullptr && desk.program()->kind == pendant::Content::kGcode;
  const int job = gcode ? 0 : pendant::kLineJob.of(message->place);
  return {fmt::format("line {}{} {}", gcode ? message->place : pendant::kLineLine.of(message->place),
                      job == 0 ? std::string{} : fmt::format(" of job {}", job + 1), message_text(*message)),
          message->header.kind == MessageKind::kMessage ? Style::kPlain : Style::kAlarm};
}

std::string position_row(const OperatorDesk& desk, std::size_t row) {
  const std::string joint =
      row < desk.joints() ? fmt::format("{:>6} {:>14}", row + 1, desk.joint_text(row)) : std::string(21, ' ');
  const double scale = row < 3 ? 1e3 : 1e4;
  return fmt::format("{}      {:>3} {:>14.{}f} {}", joint, kToolNames[row], desk.link().page(Page::kTool, row) / scale,
                     row < 3 ? 3 : 4, kToolUnits[row]);
}

// The program around the line that the operator has gone to, else around the one that the arm executes.
void add_program(const OperatorDesk& desk, std::size_t rows, std::vector<TerminalLine>& out) {
  const OperatorProgram* program = desk.program();
  if (program == nullptr) return;
  const std::int32_t current = desk.current_line();
  out.push_back({fmt::format("program {} of {}: {}, {} lines{}", desk.selected() + 1, desk.programs(), program->name,
                             program->lines.size(), desk.link().downloading() ? ", loading" : ""),
                 Style::kTitle});
  if (rows < 2) return;
  const std::size_t shown = std::min(rows - 1, program->lines.size());
  const auto centre = static_cast<std::size_t>(std::max(desk.cursor() > 0 ? desk.cursor() : current, 1)) - 1;
  const std::size_t first = std::min(centre > shown / 2 ? centre - shown / 2 : 0, program->lines.size() - shown);
  for (std::size_t i = first; i < first + shown; ++i) {
    const auto line = static_cast<std::int32_t>(i) + 1;
    const bool here = line == current, selected = line == desk.cursor();
    out.push_back(
        {fmt::format("{}{}{:>5}  {}", here ? '>' : ' ', desk.has_breakpoint(line) ? '*' : ' ', line, program->lines[i]),
         here       ? Style::kMarked
         : selected ? Style::kSelected
                    : Style::kPlain});
  }
}

std::vector<TerminalLine> key_lines() {
  std::vector<std::string> cells;
  for (const OperatorDesk::Key& key : OperatorDesk::keys()) {
    if (!key.shown.empty()) cells.push_back(fmt::format("{:>5} {:<20}", key.shown, key.does));
  }
  cells.push_back(fmt::format("{:>5} {:<20}", kQuitKey, "quit"));
  const std::size_t rows = (cells.size() + kKeyColumns - 1) / kKeyColumns;
  std::vector<TerminalLine> lines(rows);
  for (std::size_t i = 0; i < cells.size(); ++i) lines[i % rows].text += cells[i];
  for (TerminalLine& line : lines) line.style = Style::kDim;
  return lines;
}

}  // namespace

std::vector<TerminalLine> screen_lines(const OperatorDesk& desk, const std::string& line_name, std::size_t rows,
                                       std::size_t columns) {
  if (rows < kLeastRows || columns < kLeastColumns) {
    return {{fmt::format("at least {} x {}, please", kLeastColumns, kLeastRows), Style::kAlarm}};
  }
  const OperatorLink& link = desk.link();
  std::vector<TerminalLine> lines{{fmt::format("armature pendant   {}", line_name), Style::kTitle}, status_line(link)};
  lines.push_back(alarm_line(link));
  lines.push_back(message_line(desk));
  lines.push_back({fmt::format(" joint {:>14}     tool in the base", desk.joint_unit()), Style::kTitle});
  for (std::size_t row = 0; row < kToolNames.size(); ++row) lines.push_back({position_row(desk, row)});
  lines.push_back({fmt::format("jog {}   speed {} %   {}   user frame {}   override {} %",
                               kCoordinates[static_cast<std::size_t>(link.coordinates()) % kCoordinates.size()],
                               desk.jog_percent(), desk.step_text(), desk.user_frame(), desk.override_percent())});
  const std::vector<TerminalLine> keys = key_lines();
  const std::size_t fixed = lines.size() + kMessageLines + keys.size();
  if (fixed < rows) add_program(desk, rows - fixed, lines);
  const auto& messages = link.messages();
  const std::size_t said = std::min(messages.size(), kMessageLines);
  for (std::size_t i = messages.size() - said; i < messages.size(); ++i) lines.push_back({messages[i]});
  lines.insert(lines.end(), keys.begin(), keys.end());
  if (lines.size() > rows) lines.resize(rows);
  for (TerminalLine& line : lines) {
    if (line.text.size() > columns) line.text.resize(columns);
  }
  return lines;
}

}  // namespace armature::cosim
