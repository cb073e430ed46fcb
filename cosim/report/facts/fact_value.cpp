#include "cosim/report/facts/fact_value.hpp"

#include <fmt/format.h>

#include "cosim/report/facts/value_text.hpp"
#include "cosim/text/byte_text.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

struct Text {
  std::string_view unit;

  std::string operator()(std::monostate) const { return "none"; }
  std::string operator()(std::int64_t value) const { return show(value); }
  std::string operator()(double value) const { return with_unit(show(value), unit); }
  std::string operator()(const std::string& value) const { return value; }
  template <class T>
  std::string operator()(const OfAxes<T>& value) const {
    return show_list(value.values);
  }
  template <class T>
  std::string operator()(const std::vector<T>& value) const {
    return show_list(value);
  }
  std::string operator()(const Point& value) const { return show_list(value.mm); }
  std::string operator()(const Orientation& value) const { return show_list(value.rpy_deg); }
  std::string operator()(const NamedDeviation& value) const {
    return fmt::format("{} mm in {}", show_small(value.mm), value.command);
  }
  std::string operator()(const SerialText& value) const {
    std::string text = value.as_hex ? fmt::format("\"{}\"", hex_of_bytes(value.bytes)) : quoted_bytes(value.bytes);
    if (value.errors > 0) text += fmt::format(" with {} errors or breaks", value.errors);
    return text;
  }
  std::string operator()(const std::vector<OutputChange>& value) const {
    std::string text;
    for (const OutputChange& change : value) {
      text += fmt::format("{}pin {} = {} at {:.6f} s", text.empty() ? "" : ", ", change.pin, change.level ? 1 : 0,
                          to_seconds(change.at));
      if (!change.tool_mm) continue;
      const Eigen::Vector3d& mm = *change.tool_mm;
      text += fmt::format(" and [{:.4f}, {:.4f}, {:.4f}] mm", mm.x(), mm.y(), mm.z());
    }
    return text.empty() ? "none" : text;
  }
};

}  // namespace

std::string value_text(const FactValue& value, std::string_view unit) {
  return std::visit(Text{unit}, value);
}

}  // namespace armature::cosim
