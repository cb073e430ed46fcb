// The data of a run for the page: what web/run.js reads.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cosim/page/serial_record.hpp"
#include "cosim/recording/recorded_program.hpp"
#include "cosim/recording/run_record.hpp"
#include "cosim/recording/trace_table.hpp"

namespace armature::cosim {

// A trace to compare the run with.
struct OtherTrace {
  std::string name;     // such as "golden"
  std::string shown{};  // name of the run that is compared with it; empty: its scenario says enough
  TraceTable trace;
};

// What the page shows besides trace and summary.
struct PageParts {
  std::vector<SerialRecord> serial{};
  std::optional<TraceTable> load{};  // what the cores did, as load.csv says
  std::optional<OtherTrace> other{};
  std::vector<RecordedProgram> programs{};
};

[[nodiscard]] nlohmann::ordered_json run_data(const RunRecord& run, const PageParts& parts);

}  // namespace armature::cosim
