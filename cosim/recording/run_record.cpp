#include "cosim/recording/run_record.hpp"

#include <fmt/format.h>

#include <utility>

#include "cosim/text/input_error.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {

namespace {

namespace fs = std::filesystem;

// The keys that every summary has. Other parts of the file are used only if they are there.
nlohmann::ordered_json parse_summary(const std::string& text, const fs::path& file) {
  auto summary = nlohmann::ordered_json::parse(text, nullptr, false);
  const bool complete = summary.is_object() && summary.contains("scenario") && summary["scenario"].is_string() &&
                        summary.contains("description") && summary["description"].is_string() &&
                        summary.contains("result") && summary["result"].is_object() &&
                        summary["result"].contains("final_joint_deg") &&
                        summary["result"]["final_joint_deg"].is_array() && summary["result"].contains("moves") &&
                        summary["result"]["moves"].is_array();
  if (!complete) throw InputError{file.string(), "is no summary of 'armature run'"};
  return summary;
}

}  // namespace

std::size_t RunRecord::axis_count() const {
  return summary["result"]["final_joint_deg"].size();
}

std::vector<const NumberColumn*> RunRecord::axis_columns(std::string_view name) const {
  std::vector<const NumberColumn*> columns;
  for (std::size_t i = 1; i <= axis_count(); ++i) columns.push_back(&trace.column(fmt::format("j{}_{}", i, name)));
  return columns;
}

void require_run_folder(const fs::path& folder) {
  if (fs::is_directory(folder)) return;
  throw InputError{folder.string(), "is no folder; expected the results of 'armature run', such as out/NAME"};
}

RunRecord read_run_record(const fs::path& folder, const char* trace_file, const char* summary_file) {
  require_run_folder(folder);
  TraceTable trace = read_trace_table(folder / trace_file);  // reported first if both are missing
  const fs::path file = folder / summary_file;
  return {.folder = folder,
          .trace = std::move(trace),
          .summary = parse_summary(read_text_file(file, kMaxTableBytes), file)};
}

RunRecord read_run_record(const fs::path& folder, const char* trace_file, const std::string& summary,
                          const fs::path& summary_file) {
  return {.folder = folder,
          .trace = read_trace_table(folder / trace_file),
          .summary = parse_summary(summary, summary_file)};
}

}  // namespace armature::cosim
