#include "cosim/scenario/toml/toml_document.hpp"

// The only file that includes the TOML library: it is slow to compile.
#include <toml++/toml.h>

#include <algorithm>
#include <cstring>
#include <tuple>

#include "cosim/scenario/toml/toml_limits.hpp"
#include "cosim/text/byte_order_mark.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

Origin origin_of(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column), {}};
}

ConfigValue convert(const toml::node& node) {
  ConfigValue value;
  value.origin = origin_of(node.source());
  if (const auto* table = node.as_table()) {
    ConfigValue::Table entries;
    for (const auto& [key, child] : *table) {
      entries.push_back({std::string{key.str()}, origin_of(key.source()), convert(child)});
    }
    // The library sorts by name. Messages and suggestions need the order of the file.
    std::stable_sort(entries.begin(), entries.end(), [](const ConfigEntry& a, const ConfigEntry& b) {
      return std::tie(a.origin.line, a.origin.column) < std::tie(b.origin.line, b.origin.column);
    });
    value.data = std::move(entries);
  } else if (const auto* array = node.as_array()) {
    ConfigValue::Array elements;
    for (const toml::node& child : *array) elements.push_back(convert(child));
    value.data = std::move(elements);
  } else if (const auto* boolean = node.as_boolean()) {
    value.data = boolean->get();
  } else if (const auto* integer = node.as_integer()) {
    value.data = integer->get();
  } else if (const auto* number = node.as_floating_point()) {
    value.data = number->get();
  } else if (const auto* string = node.as_string()) {
    value.data = string->get();
  } else {
    value.data = ConfigValue::Date{};
  }
  return value;
}

}  // namespace

ConfigValue parse_toml(std::string_view text, const std::string& file) {
  check_toml_limits(text, file);
  try {
    return convert(toml::parse(without_byte_order_mark(text)));
  } catch (const toml::parse_error& error) {
    std::string message{error.description()};
    if (message.starts_with("Error while ")) message.replace(0, std::strlen("Error while "), "while ");
    throw InputError{Problem{file, origin_of(error.source()), {}, "TOML syntax: " + message}};
  }
}

std::string read_toml(const std::filesystem::path& file) {
  require_regular_file(file);
  return read_text_file(file, kMaxTomlBytes);
}

}  // namespace armature::cosim
