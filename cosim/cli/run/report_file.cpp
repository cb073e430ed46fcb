#include "cosim/cli/run/report_file.hpp"

#include <string>

#include "cosim/cli/run/recorded_run.hpp"
#include "cosim/golden/golden.hpp"
#include "cosim/page/run_data.hpp"
#include "cosim/page/serial_record.hpp"
#include "cosim/run/run_folder.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

// The golden that the run was compared with, if it is still there. The first input of a run is its scenario.
std::optional<OtherTrace> golden_of(const RunRecord& run) {
  const auto& summary = run.summary;
  const std::string verdict = summary["result"].value("golden", "");
  if (verdict != "equal" && verdict != "differs") return std::nullopt;
  if (!summary.contains("inputs") || !summary["inputs"].is_array() || summary["inputs"].empty()) return std::nullopt;
  const fs::path golden = fs::path{summary["inputs"][0].value("file", "")}.parent_path() / kGoldenFile;
  if (!is_file(golden)) return std::nullopt;
  return OtherTrace{.name = "golden", .trace = read_trace_table(golden)};
}

}  // namespace

std::string write_report(const fs::path& folder, const fs::path& page, const ReportRequest& request) {
  const RunRecord run = request.so_far ? run_record_so_far(folder) : recorded_run(folder);
  const auto& other = request.other;
  const auto compared = other
                            ? std::optional{OtherTrace{
                                  .name = other->string(), .shown = run.trace.file, .trace = read_trace_table(*other)}}
                            : golden_of(run);
  const fs::path load_file = folder / kLoadFile;
  const auto load = is_file(load_file) ? std::optional{read_trace_table(load_file)} : std::nullopt;
  const auto data = run_data(run, {.serial = read_serial_record(folder / kSerialFile),
                                   .load = load,
                                   .other = compared,
                                   .programs = recorded_programs(run.summary)});
  const ReportPage report = report_page(data, request.page);
  replace_text_file(page, report.text);
  return report.digest;
}

std::string write_reloading_report(const fs::path& folder, const fs::path& page, ReportRequest request) {
  request.page.reloads = true;
  std::string digest = write_report(folder, page, request);
  replace_text_file(page.parent_path() / kReloadFile, reload_script(digest, ""));
  return digest;
}

}  // namespace armature::cosim
