#include "cosim/scenario/toml/old_logic_key.hpp"

#include <string>
#include <string_view>
#include <variant>

#include "controller/base/words.hpp"
#include "cosim/logic/logic_spec.hpp"

namespace armature::cosim {
namespace {

constexpr std::string_view kNewKey = "variant";

std::string assignment(std::string_view name) {
  std::string text{kNewKey};
  return text.append(" = \"").append(name).append("\"");
}

}  // namespace

void refuse_old_logic_key(ConfigValue& root, ProblemList& problems) {
  ConfigEntry* entry = root.find(kOldLogicKey);
  if (entry == nullptr) return;
  const auto* value = std::get_if<std::string>(&entry->value.data);
  const std::string_view meant = value == nullptr ? std::string_view{} : variant_of_old_key(*value);
  std::string advice;
  for (const std::string_view name : kWordsOf<Variant>) {
    if (meant.empty() || meant == name) advice += (advice.empty() ? "write " : " or ") + assignment(name);
  }
  problems.add(entry->value.origin, kOldLogicKey, "no longer a key, " + advice);
  if (!meant.empty() && root.find(kNewKey) == nullptr) {
    entry->key = kNewKey;
    entry->value.data = std::string{meant};
  } else {
    std::erase_if(*root.table(), [](const ConfigEntry& one) { return one.key == kOldLogicKey; });
  }
}

}  // namespace armature::cosim
