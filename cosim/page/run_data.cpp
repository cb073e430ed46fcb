#include "cosim/page/run_data.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "cosim/page/column_code.hpp"
#include "cosim/recording/recorded_path.hpp"

namespace armature::cosim {
namespace {

using Json = nlohmann::ordered_json;

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
    ColumnCode code = column_code(column.values);
    columns.push_back({{"name", column.name},
                       {"digits", column.digits},
                       {"rows", column.values.size()},
                       {"order", code.order},
                       {"data", std::move(code.text)}});
  }
  Json states = Json::array();
  for (const StateSpan& span : trace.states) states.push_back(Json::array({span.first_row, span.state}));
  return {{"columns", std::move(columns)}, {"states", std::move(states)}};
}

// The curve of a spline as cubics: for each piece between two points, four coefficients of x, y and z, from the lowest
// power of u = 0..1.
Json cubics_json(const Spline& curve) {
  Json pieces = Json::array();
  for (std::size_t i = 0; i + 1 < curve.points_mm().size(); ++i) {
    Json piece = Json::array();
    for (const Eigen::Vector3d& c : curve.cubic_mm(i)) piece.push_back({c.x(), c.y(), c.z()});
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace

Json run_data(const RunRecord& run, const std::vector<SerialRecord>& serial, const std::optional<TraceTable>& load,
              const std::optional<OtherTrace>& other) {
  Json data = {{"summary", run.summary}, {"trace", trace_json(run.trace)}};
  data["summary"].erase("host");  // the page has the same bytes on every machine
  for (Json& move : data["summary"]["result"]["moves"]) {
    const std::optional<RecordedPath> recorded = recorded_path(move);
    if (recorded && recorded->curve) move["path"]["cubics_mm"] = cubics_json(*recorded->curve);
  }
  Json bytes = Json::array();
  for (const SerialRecord& one : serial) {
    bytes.push_back({{"time", one.time_s}, {"direction", one.direction}, {"text", one.text}, {"error", one.error}});
  }
  data["serial"] = std::move(bytes);
  data["load"] = load ? trace_json(*load) : Json(nullptr);
  data["other"] = other ? Json{{"name", other->name}, {"trace", trace_json(other->trace)}} : Json(nullptr);
  return data;
}

}  // namespace armature::cosim
