#include "cosim/live/page_message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace armature::cosim {
namespace {

// Without exceptions, and without deep recursion: the depth is limited while the text is read.
nlohmann::json parse_message(std::string_view text) {
  bool too_deep = false;
  const auto limit = [&too_deep](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
    too_deep = too_deep || depth > PageMessage::kMaxDepth;
    return !too_deep;
  };
  nlohmann::json json = nlohmann::json::parse(text, limit, false);
  if (too_deep) throw MessageError{"a message has at most four levels"};
  if (!json.is_object()) throw MessageError{"a message is a JSON object such as {\"do\": \"beat\"}"};
  return json;
}

}  // namespace

PageMessage::PageMessage(std::string_view text) : json_(parse_message(text)) {
  constexpr std::size_t kLongestName = 32;
  what_ = this->text("do", kLongestName);
}

const nlohmann::json& PageMessage::field(const char* key) const {
  const auto found = json_.find(key);
  if (found == json_.end()) throw MessageError{fmt::format("{}: the field \"{}\" is missing", what_, key)};
  return *found;
}

std::int64_t PageMessage::integer(const char* key, std::int64_t min, std::int64_t max) const {
  const double value = number(key, static_cast<double>(min), static_cast<double>(max));
  if (std::floor(value) != value) throw MessageError{fmt::format("{}: \"{}\" must be a whole number", what_, key)};
  return static_cast<std::int64_t>(value);
}

double PageMessage::number(const char* key, double min, double max) const {
  const nlohmann::json& value = field(key);
  if (!value.is_number() || !(value.get<double>() >= min && value.get<double>() <= max)) {
    throw MessageError{fmt::format("{}: \"{}\" must be a number from {} to {}", what_, key, min, max)};
  }
  return value.get<double>();
}

bool PageMessage::flag(const char* key) const {
  const nlohmann::json& value = field(key);
  if (!value.is_boolean()) throw MessageError{fmt::format("{}: \"{}\" must be true or false", what_, key)};
  return value.get<bool>();
}

std::string PageMessage::text(const char* key, std::size_t longest) const {
  const nlohmann::json& value = field(key);
  if (!value.is_string() || value.get_ref<const std::string&>().size() > longest) {
    throw MessageError{fmt::format("{}: \"{}\" must be a text of at most {} characters", what_, key, longest)};
  }
  return value.get<std::string>();
}

ConfigValue PageMessage::table(const char* key) const {
  constexpr std::size_t kMost = 32, kLongest = 64;
  const nlohmann::json& fields = field(key);
  if (!fields.is_object() || fields.size() > kMost) {
    throw MessageError{fmt::format("{}: \"{}\" must be an object of at most {} values", what_, key, kMost)};
  }
  ConfigValue::Table table;
  for (const auto& [name, value] : fields.items()) {
    ConfigValue::Data data;
    if (value.is_boolean()) {
      data = value.get<bool>();
    } else if (value.is_number_integer()) {
      data = value.get<std::int64_t>();
    } else if (value.is_number()) {
      data = value.get<double>();
    } else if (value.is_string() && value.get_ref<const std::string&>().size() <= kLongest) {
      data = value.get<std::string>();
    } else {
      throw MessageError{fmt::format("{}: \"{}\" must be a number, a flag or a short text", what_, name)};
    }
    table.push_back({.key = name, .origin = {}, .value = {std::move(data), {}}});
  }
  return {std::move(table), {}};
}

std::vector<double> PageMessage::numbers(const char* key, std::size_t count, double largest) const {
  const nlohmann::json& values = field(key);
  const auto fits = [largest](const nlohmann::json& value) {
    return value.is_number() && std::fabs(value.get<double>()) <= largest;
  };
  if (!values.is_array() || values.size() != count || !std::all_of(values.begin(), values.end(), fits)) {
    throw MessageError{
        fmt::format("{}: \"{}\" must be {} numbers from {} to {}", what_, key, count, -largest, largest)};
  }
  return values.get<std::vector<double>>();
}

}  // namespace armature::cosim
