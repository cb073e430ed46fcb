// What a run wrote into its folder: the trace and the summary, for pictures and reports.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/recording/trace_table.hpp"

namespace armature::cosim {

struct RunRecord {
  std::filesystem::path folder;
  TraceTable trace;
  nlohmann::ordered_json summary;  // summary.json, as scenarios/RESULTS.md describes it

  // Axes of the robot.
  [[nodiscard]] std::size_t axis_count() const;
  // A column of the trace for each axis: `enc_deg` stands for j1_enc_deg, j2_enc_deg and so on. It refers to `trace`.
  [[nodiscard]] std::vector<const NumberColumn*> axis_columns(std::string_view name) const;
};

// Throws InputError when there is no such folder.
void require_run_folder(const std::filesystem::path& folder);

// Throws InputError when a file is missing or is not what `armature run` writes.
[[nodiscard]] RunRecord read_run_record(const std::filesystem::path& folder, const char* trace_file,
                                        const char* summary_file);

// The same with the text of a summary that is in another file.
[[nodiscard]] RunRecord read_run_record(const std::filesystem::path& folder, const char* trace_file,
                                        const std::string& summary, const std::filesystem::path& summary_file);

}  // namespace armature::cosim
