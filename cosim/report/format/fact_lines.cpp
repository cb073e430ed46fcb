#include "cosim/report/format/fact_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "cosim/report/facts/fact.hpp"
#include "cosim/report/facts/value_text.hpp"
#include "cosim/report/format/screen_line.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

enum class Part { kNumbers, kAxes, kTool };

// The text after the label. Empty: the fact has no line in this part of the summary.
struct LineText {
  const Fact& fact;
  Part part;

  std::string operator()(std::int64_t value) const {
    if (part != Part::kNumbers || (fact.screen.unless_zero && value == 0)) return {};
    return with_unit(std::to_string(value), fact.unit);
  }
  std::string operator()(double value) const {
    if (part != Part::kNumbers || (fact.screen.unless_zero && value == 0)) return {};
    return with_unit(fmt::format("{:.{}f}", value, fact.screen.digits), fact.unit);
  }
  template <class T>
  std::string operator()(const OfAxes<T>& value) const {
    const bool zero = std::ranges::all_of(value.values, [](const T& of_axis) { return of_axis == T{}; });
    if (part != Part::kAxes || (fact.screen.unless_zero && zero)) return {};
    return columns(value.values, fact.screen.digits);
  }
  std::string operator()(const Point& value) const {
    return part == Part::kTool ? columns(value.mm, fact.screen.digits) : std::string{};
  }
  std::string operator()(const Orientation& value) const {
    return part == Part::kTool ? columns(value.rpy_deg, fact.screen.digits) : std::string{};
  }
  std::string operator()(const NamedDeviation& value) const {
    if (part != Part::kTool) return {};
    // Four digits after the point would show a very small value as 0.
    const bool tiny = value.mm > 0 && value.mm < 1e-4;
    return fmt::format("{} mm at {:.6f} s in {}",
                       tiny ? fmt::format("{:.1e}", value.mm) : fmt::format("{:.4f}", value.mm),
                       to_seconds(value.where.at), value.command);
  }
  // No fact of these types has a line of its own.
  template <class T>
  std::string operator()(const T&) const {
    return {};
  }
};

std::string lines(const RunSummary& summary, Part part) {
  std::string out;
  for (const Fact& fact : fact_list()) {
    if (fact.screen.label.empty() || !summary.has(fact.group)) continue;
    const std::string text = std::visit(LineText{fact, part}, fact.value(summary.facts));
    if (!text.empty()) add_line(out, fact.screen.label, text);
  }
  return out;
}

}  // namespace

std::string number_lines(const RunSummary& summary) {
  return lines(summary, Part::kNumbers);
}

std::string axis_lines(const RunSummary& summary) {
  std::vector<std::int64_t> axes;
  for (std::size_t axis = 1; axis <= summary.facts.axis_count; ++axis) axes.push_back(static_cast<std::int64_t>(axis));
  std::string out;
  add_line(out, "axis", columns(axes, 0));
  return out + lines(summary, Part::kAxes);
}

std::string tool_lines(const RunSummary& summary) {
  return lines(summary, Part::kTool);
}

std::vector<std::pair<std::string, std::string>> fact_properties(const RunSummary& summary) {
  std::vector<std::pair<std::string, std::string>> properties;
  for (const Fact& fact : fact_list()) {
    const FactValue value = fact.value(summary.facts);
    if (!summary.has(fact.group) || std::holds_alternative<std::monostate>(value)) continue;
    properties.emplace_back(fact.name, value_text(value));
  }
  return properties;
}

}  // namespace armature::cosim
