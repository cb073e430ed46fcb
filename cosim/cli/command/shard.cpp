#include "cosim/cli/command/shard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string_view>

#include "cosim/text/input_error.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {

Shard shard_of(const std::string& option) {
  std::string text = option, name = "--shard";
  if (text.empty()) {
    const char* total = std::getenv("TEST_TOTAL_SHARDS");
    const char* index = std::getenv("TEST_SHARD_INDEX");
    if (total == nullptr || index == nullptr) return {};
    text = fmt::format("{}/{}", index, total);
    name = "TEST_SHARD_INDEX/TEST_TOTAL_SHARDS";
  }
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto index = parsed_number<std::int64_t>(std::string_view{text}.substr(0, slash));
  const auto total = parsed_number<std::int64_t>(std::string_view{text}.substr(std::min(slash + 1, text.size())));
  if (!index || !total || *index < 0 || *index >= *total) {
    throw InputError{name, fmt::format("expected I/N with 0 <= I < N, found {}", printable(text))};
  }
  return {*index, *total};
}

}  // namespace armature::cosim
