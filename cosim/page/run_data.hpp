// The data of a run for the page: what web/run.js reads.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cosim/page/serial_record.hpp"
#include "cosim/recording/run_record.hpp"
#include "cosim/recording/trace_table.hpp"

namespace armature::cosim {

// A trace to compare the run with.
struct OtherTrace {
  std::string name;  // such as "golden"
  TraceTable trace;
};

// `load`: what the cores did, as load.csv says.
[[nodiscard]] nlohmann::ordered_json run_data(const RunRecord& run, const std::vector<SerialRecord>& serial,
                                              const std::optional<TraceTable>& load,
                                              const std::optional<OtherTrace>& other);

}  // namespace armature::cosim
