#include "cosim/report/format/json/comparison_json.hpp"

#include <cmath>
#include <utility>

#include "cosim/text/json.hpp"

namespace armature::cosim {
namespace {

Json position_json(const RowPosition& at) {
  return {{"tick", at.tick}, {"time_s", at.time_s ? Json(*at.time_s) : Json(nullptr)}};
}

Json first_json(const Mismatch& first) {
  Json json = position_json(first.at);
  json["column"] = first.column;
  json["a"] = first.value_a;
  json["b"] = first.value_b;
  return json;
}

}  // namespace

Json comparison_json(const Comparison& comparison) {
  Json columns = Json::array();
  for (const ColumnDeviation& column : comparison.columns) {
    if (column.largest == 0 && column.rows == 0) continue;
    columns.push_back({{"column", column.column},
                       {"largest", std::isfinite(column.largest) ? Json(column.largest) : Json(nullptr)},
                       {"tick", column.tick},
                       {"rows", column.rows}});
  }
  Json json = {{"equal", comparison.equal()},
               {"a", comparison.a.file},
               {"b", comparison.b.file},
               {"rows", comparison.rows},
               {"rows_differ", comparison.rows_differ},
               {"rows_only_a", comparison.rows_only_a},
               {"rows_only_b", comparison.rows_only_b},
               {"rows_between", comparison.rows_between},
               {"columns_only_a", comparison.columns_only_a},
               {"columns_only_b", comparison.columns_only_b}};
  json["first"] = comparison.first ? first_json(*comparison.first) : Json(nullptr);
  json["integers_differ"] = nullptr;
  if (const auto& digest = comparison.digest) {
    json["integers_differ"] = {{"after", digest->after ? position_json(*digest->after) : Json(nullptr)},
                               {"until", position_json(digest->until)}};
  }
  json["columns"] = std::move(columns);
  return json;
}

}  // namespace armature::cosim
