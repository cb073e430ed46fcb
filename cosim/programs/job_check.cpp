#include "cosim/programs/job_check.hpp"

#include <iterator>
#include <string_view>
#include <utility>

namespace armature::cosim {

void JobCheck::load(const ProgramFile& file) {
  accepted_ = loader_->load(file.file, file.text) && accepted_;
}

std::vector<std::string> JobCheck::new_missing_jobs() {
  std::vector<std::string> names;
  for (; records_ < memory_->record_count; ++records_) {
    for (const job::Operand& operand : memory_->operands_of(memory_->records[records_])) {
      if (operand.kind != job::OperandKind::kJob) continue;
      const std::string_view name = memory_->text_at(job::text_of(operand));
      if (memory_->job_named(name) == memory_->job_count && asked_for_.insert(std::string{name}).second) {
        names.emplace_back(name);
      }
    }
  }
  return names;
}

void JobCheck::finish(std::vector<Problem>& all) {
  if (accepted_) static_cast<void>(loader_->link());  // otherwise jobs with errors are missing
  std::move(problems_.all.begin(), problems_.all.end(), std::back_inserter(all));
  problems_.all.clear();
}

void JobCheck::Problems::report(const Diagnostic& diagnostic) noexcept {
  if (diagnostic.severity != Diagnostic::Severity::kError) return;
  all.push_back({.file = std::string{diagnostic.file},
                 .origin = {.line = static_cast<int>(diagnostic.line),
                            .column = static_cast<int>(diagnostic.column),
                            .override_text = {}},
                 .key = {},
                 .message = std::string{diagnostic.text.view()}});
}

}  // namespace armature::cosim
