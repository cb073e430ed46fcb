#include "cosim/live/live_faults.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "controller/regs/soc_map.hpp"
#include "cosim/live/page_message.hpp"
#include "cosim/scenario/keys/key_context.hpp"
#include "cosim/scenario/kinds.hpp"
#include "cosim/scenario/tables/fault_kinds.hpp"
#include "cosim/scenario/tables/tables.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

struct Suggestion {
  std::string_view key;
  double value;
};

// For keys whose smallest value shows nothing. Others get 1, or what is nearest to it.
constexpr std::array kSuggestions{
    Suggestion{"duration_s", 0.1},  Suggestion{"count", 100},    Suggestion{"counts", 100},
    Suggestion{"compute_us", 60},   Suggestion{"period_us", 40}, Suggestion{"width_us", 2},
    Suggestion{"mean_gap_us", 200}, Suggestion{"delay_us", 1},   Suggestion{"address", regs::soc::kPulseTrainBase},
};

Json suggested_value(const KeyInfo& key) {
  if (!key.rule.choices.empty()) return key.rule.choices.front();
  const auto known = std::ranges::find(kSuggestions, key.name, &Suggestion::key);
  const double wish = known == kSuggestions.end() ? 1 : known->value;
  const double value = std::clamp(wish, key.rule.min, key.rule.max);
  return key.kind == ValueKind::kInteger ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

Json key_json(const KeyInfo& key, const RobotSpec& robot) {
  const bool is_axis = key.name == "axis";
  const auto limit = [](double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); };
  return {{"key", key.name},
          {"text", key.text},
          {"unit", key.rule.unit},
          {"min", limit(key.rule.min)},
          {"max", limit(is_axis ? static_cast<double>(robot.axis_count) : key.rule.max)},
          {"choices", key.rule.choices.empty() ? Json(nullptr) : Json(key.rule.choices)},
          {"whole", key.kind == ValueKind::kInteger},
          {"value", suggested_value(key)}};
}

void set(ConfigValue& table, std::string key, ConfigValue::Data value) {
  table.table()->push_back({.key = std::move(key), .origin = {}, .value = {std::move(value), {}}});
}

}  // namespace

Json fault_kinds_json(const RobotSpec& robot) {
  Json kinds = Json::array();
  for_each_kind<FaultKind>([&]<class Kind>(std::type_identity<Kind>) {
    if (FaultInside<Kind>) return;  // there are too many to choose from
    const FaultEntry<Kind>& entry = fault_entry<Kind>();
    Json keys = Json::array();
    for (const PlainKey& key : entry.keys.plain()) keys.push_back(key_json(key.info, robot));
    kinds.push_back({{"kind", entry.name}, {"text", entry.text}, {"keys", std::move(keys)}});
  });
  return kinds;
}

FaultSpec read_fault(ConfigValue table, const Scenario& scenario, Cycles now) {
  FaultSpec fault;
  ProblemList problems{"fault"};
  if (table.find("at_s") != nullptr) throw MessageError{"fault: it begins now, \"at_s\" is not needed"};
  set(table, "at_s", to_seconds(now));
  TableReader reader{table, "", problems};
  const ScenarioRobot robot{.spec = &scenario.robot, .file = scenario.robot_name};
  fault_keys().read(reader, {.robot = robot, .scenario = &scenario}, fault);
  if (fault.when != FaultWhen::kTime) throw MessageError{"fault: it begins now and waits for nothing, see \"when\""};
  std::visit(
      []<class Kind>(const Kind&) {
        if (FaultInside<Kind>) {
          throw MessageError{fmt::format("fault: {} is for scenarios only", fault_entry<Kind>().name)};
        }
      },
      fault.kind);
  reader.finish();
  std::vector<Problem> found;
  problems.move_to(found);
  if (!found.empty()) throw MessageError{found.front().text()};
  return fault;
}

}  // namespace armature::cosim
