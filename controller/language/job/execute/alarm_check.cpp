#include "controller/language/job/execute/alarm_check.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "controller/language/job/memory/switches.hpp"
#include "controller/language/job/state/alarm.hpp"

namespace armature::job {
namespace {

class AlarmCheck {
 public:
  AlarmCheck(const ProgramMemory& memory, const MachineSettings& settings, Diagnostics& diagnostics) noexcept
      : memory_{memory}, settings_{settings}, diagnostics_{diagnostics} {}

  void check(const JobInfo& job) noexcept {
    file_ = memory_.text_at(job.file);
    for (const Record& record : memory_.records_of(job)) check(record);
  }

 private:
  void check(const Record& record) noexcept {
    const Instruction& instruction = instruction_of(record.op);
    if (!is_supported(record.op)) {
      const std::optional<Switch> found = switch_of(record.op);
      if (found && settings_.pin_of(found->device) != 0) return;
      DiagnosticText text{instruction.name};
      text << ": not supported";
      if (found) text << " without its output in [job]";
      return warn(record, text);
    }
    if ((record.flags & Record::kUnsupported) != 0) {
      DiagnosticText text{instruction.name};
      text << ": external axes, a second group and searches are not supported";
      return warn(record, text);
    }
    if (is_move(record.op)) check_target(record);
  }

  void check_target(const Record& record) noexcept {
    const std::span<const Operand> operands = memory_.operands_of(record);
    if (operands.empty() || operands.front().kind != OperandKind::kPosition) return;
    const Position& position = memory_.positions[static_cast<std::size_t>(operands.front().number)];
    const bool of_tool = position.frame == Frame::kTool || position.frame == Frame::kMasterTool;
    if (of_tool) {
      DiagnosticText text{instruction_of(record.op).name};
      text << ": a position in the frame of a tool is not supported";
      return warn(record, text);
    }
    // The tool of a joint position has no effect on a move of the joints.
    const bool joints = position.frame == Frame::kPulse || position.frame == Frame::kAngle;
    if (joints && record.op == Op::kMovj) return;
    if (settings_.flange_T_tool[position.tool]) return;
    if (arm_tool_ == kNoTool) arm_tool_ = position.tool;
    if (arm_tool_ == position.tool) return;
    DiagnosticText text{instruction_of(record.op).name};
    text << ": TOOL " << std::uint32_t{position.tool} << " besides TOOL " << arm_tool_ << " needs [[job.tool]]";
    warn(record, text);
  }

  void warn(const Record& record, const DiagnosticText& text) noexcept {
    Diagnostic diagnostic{.severity = Diagnostic::Severity::kWarning, .file = file_, .line = record.line, .column = 1};
    diagnostic.text = text;
    diagnostic.text << "; when executed, it is an alarm";
    diagnostics_.report(diagnostic);
  }

  const ProgramMemory& memory_;
  const MachineSettings& settings_;
  Diagnostics& diagnostics_;
  std::string_view file_{};
  static constexpr int kNoTool = -1;
  int arm_tool_ = kNoTool;  // of all jobs
};

}  // namespace

void warn_of_alarms(const ProgramMemory& memory, const MachineSettings& settings, Diagnostics& diagnostics) noexcept {
  AlarmCheck check{memory, settings, diagnostics};
  for (std::size_t i = 0; i < memory.job_count; ++i) check.check(memory.jobs[i]);
}

}  // namespace armature::job
