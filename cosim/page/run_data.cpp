#include "cosim/page/run_data.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "cosim/page/arm_meshes.hpp"
#include "cosim/page/column_json.hpp"
#include "cosim/page/path_error.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {
namespace {

// The page computes the tool point and the pulses of a tick from other columns.
bool is_shown(const NumberColumn& column) {
  constexpr std::array<std::string_view, 6> kShown{"_ref_deg",    "_enc_deg",      "_enc_counts",
                                                   "_pin_pulses", "_awake_cycles", "_bus_cycles"};
  return column.name == "tick" || column.name == "time_s" ||
         std::ranges::any_of(kShown, [&](std::string_view end) { return column.name.ends_with(end); });
}

bool has_number_in_every_row(const NumberColumn& column) {
  return std::ranges::find(column.values, NumberColumn::kNone) == column.values.end();
}

Json trace_json(const TraceTable& trace) {
  Json columns = Json::array();
  for (const NumberColumn& column : trace.columns) {
    if (!is_shown(column) || !has_number_in_every_row(column)) continue;
    columns.push_back(column_json(column.name, column.digits, column.values));
  }
  Json states = Json::array();
  for (const StateSpan& span : trace.states) states.push_back(Json::array({span.first_row, span.state}));
  return {{"columns", std::move(columns)}, {"states", std::move(states)}};
}

Json errors_json(const RunRecord& run) {
  const std::optional<PathErrors> errors = path_errors(run);
  if (!errors) return nullptr;
  return {{"encoder", column_json("", PathErrors::kDigits, errors->encoders)},
          {"reference", column_json("", PathErrors::kDigits, errors->set_points)}};
}

}  // namespace

Json run_data(const RunRecord& run, const PageParts& parts) {
  Json data = {{"summary", run.summary}, {"trace", trace_json(run.trace)}};
  data["summary"].erase("host");  // the page has the same bytes on every machine
  data["errors"] = errors_json(run);
  data["meshes"] = recorded_meshes(run.summary);
  Json bytes = Json::array();
  for (const SerialRecord& one : parts.serial) {
    bytes.push_back({{"time", one.time_s}, {"direction", one.direction}, {"text", one.text}, {"error", one.error}});
  }
  data["serial"] = std::move(bytes);
  data["load"] = parts.load ? trace_json(*parts.load) : Json(nullptr);
  data["programs"] = Json::array();
  for (const RecordedProgram& one : parts.programs) {
    data["programs"].push_back({{"name", one.name}, {"text", one.text}, {"problem", one.problem}});
  }
  data["other"] =
      parts.other
          ? Json{{"name", parts.other->name}, {"shown", parts.other->shown}, {"trace", trace_json(parts.other->trace)}}
          : Json(nullptr);
  return data;
}

}  // namespace armature::cosim
