#include "cosim/campaign/draw_fault.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <type_traits>
#include <utility>

#include "cosim/fabric/register_names.hpp"
#include "cosim/scenario/keys/key_info.hpp"
#include "cosim/scenario/kinds.hpp"
#include "cosim/scenario/tables/fault_kinds.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

struct KindKeys {
  std::string_view name;
  std::vector<KeyInfo> keys;
};

const std::vector<KindKeys>& kinds() {
  static const std::vector<KindKeys> kKinds = [] {
    std::vector<KindKeys> all;
    for_each_kind<FaultKind>([&]<class Kind>(std::type_identity<Kind>) {
      if (FaultInside<Kind>) return;
      KindKeys kind{.name = fault_entry<Kind>().name, .keys = {}};
      for (const PlainKey& key : fault_entry<Kind>().keys.plain()) kind.keys.push_back(key.info);
      all.push_back(std::move(kind));
    });
    return all;
  }();
  return kKinds;
}

const KindKeys& kind_of(std::string_view name) {
  return *std::ranges::find(kinds(), name, &KindKeys::name);
}

// Of the variant `counts`, elements of arrays included.
const std::vector<std::uint32_t>& registers() {
  static const std::vector<std::uint32_t> kRegisters = [] {
    std::vector<std::uint32_t> all;
    for (const RegisterName& entry : kRegisterNames) {
      if (!entry.in_counts) continue;
      for (std::uint32_t i = 0; i < entry.count; ++i) all.push_back(entry.address + 4 * i);
    }
    return all;
  }();
  return kRegisters;
}

// A range that is wider than this is drawn by decades: small values are more often of interest than large ones.
constexpr double kNarrow = 64;
constexpr double kLongestFaultS = 0.3;  // of a fault: a run takes a second
constexpr double kMostCounts = 1e5;     // of anything that is counted, but for words
constexpr double kLeastPart = 1e-10;    // of a range that begins at 0, where its decades begin

std::string integer_text(Draw& draw, const Rule& rule) {
  if (rule.max - rule.min <= kNarrow) {
    return std::to_string(draw.integer(static_cast<std::int64_t>(rule.min), static_cast<std::int64_t>(rule.max)));
  }
  const double most = rule.max >= kMaxWord ? rule.max : std::min(rule.max, kMostCounts);
  const auto value = std::llround(draw.decades(std::max(rule.min, 1.0), most));
  return std::to_string(rule.min < 0 && draw.chance(0.5) ? -value : value);
}

std::string number_in(Draw& draw, const Rule& rule) {
  if (!rule.numbers.empty()) return number_text(draw.one_of(rule.numbers));
  if (rule.min < 0) return number_text(std::stod(fixed_text(draw.number(rule.min, rule.max), 3)));
  return number_text(draw.decades(std::max(rule.min, rule.max * kLeastPart), rule.max));
}

std::string value_text(Draw& draw, const RobotSpec& robot, const KeyInfo& key) {
  Rule rule = key.rule;
  if (!rule.choices.empty()) return fmt::format("\"{}\"", draw.one_of(rule.choices));
  if (key.name == "axis") rule.max = static_cast<double>(robot.axis_count);
  if (key.name == "address" && rule.max >= kMaxWord) return std::to_string(draw.one_of(registers()));
  if (key.name == "duration_s") rule.max = kLongestFaultS;
  switch (key.kind) {
    case ValueKind::kBoolean:
      return draw.chance(0.5) ? "true" : "false";
    case ValueKind::kInteger:
      return integer_text(draw, rule);
    default:
      return number_in(draw, rule);
  }
}

using Written = std::map<std::string_view, std::string>;

bool holds(const Condition& condition, const Written& written) {
  const auto other = written.find(condition.key);
  if (other == written.end()) return condition.excluded;
  if (condition.values.empty()) return true;
  const bool has = std::ranges::any_of(
      condition.values, [&](std::string_view value) { return other->second == fmt::format("\"{}\"", value); });
  return has != condition.excluded;
}

bool is_drawn(Draw& draw, const KeyInfo& key, const Written& written) {
  const auto has = [&](std::string_view name) { return !name.empty() && written.contains(name); };
  if (!key.refused.empty() || key.is_array || has(key.replaces)) return false;
  if (!std::ranges::all_of(key.conditions, [&](const Condition& one) { return holds(one, written); })) return false;
  return (key.need == Need::kRequired && !has(key.spared_by)) || draw.chance(0.5);
}

}  // namespace

const std::vector<std::string_view>& fault_kind_names() {
  static const std::vector<std::string_view> kNames = [] {
    std::vector<std::string_view> names;
    for (const KindKeys& kind : kinds()) names.push_back(kind.name);
    return names;
  }();
  return kNames;
}

std::string draw_fault(Draw& draw, const RobotSpec& robot, double at_s, const std::vector<std::string>& names) {
  const KindKeys& kind = names.empty() ? draw.one_of(kinds()) : kind_of(draw.one_of(names));
  std::string text = fmt::format("at_s = {}\nkind = \"{}\"\n", fixed_text(at_s, 7), kind.name);
  Written written;
  for (const KeyInfo& key : kind.keys) {
    if (!is_drawn(draw, key, written)) continue;
    const auto& [name, value] = *written.emplace(key.name, value_text(draw, robot, key)).first;
    text += fmt::format("{} = {}\n", name, value);
  }
  return text;
}

}  // namespace armature::cosim
