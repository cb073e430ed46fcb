// The memory of the cores, as faults reach it: physical addresses, and the names that the firmware has for some of
// them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace armature::cosim {

struct CoreMemory {
  // What the firmware uses for one purpose. `begin` and `bytes` are multiples of 4.
  struct Part {
    std::string name{};
    std::uint32_t begin = 0, bytes = 0;
  };
  std::vector<Part> parts{};                                    // empty: the cores have no memory of their own
  std::map<std::string, std::uint32_t, std::less<>> symbols{};  // address by name

  [[nodiscard]] bool has_word(std::uint32_t address) const {
    return std::ranges::any_of(parts, [address](const Part& part) { return address - part.begin < part.bytes; });
  }
  // Of the word `offset` bytes behind a symbol. None: there is no such symbol, or no memory.
  [[nodiscard]] std::optional<std::uint32_t> word_at(std::string_view symbol, std::int64_t offset) const {
    const auto found = symbols.find(symbol);
    if (found == symbols.end()) return std::nullopt;
    const std::int64_t address = found->second + offset;
    if (address < 0 || address > 0xFFFF'FFFF || !has_word(static_cast<std::uint32_t>(address))) return std::nullopt;
    return static_cast<std::uint32_t>(address);
  }
  // The nearest symbol that is not behind an address, and the offset from it [bytes]. There must be one.
  [[nodiscard]] std::pair<std::string, std::int64_t> place_of(std::uint32_t address) const {
    const std::pair<const std::string, std::uint32_t>* nearest = nullptr;
    for (const auto& symbol : symbols) {
      if (symbol.second > address || (nearest != nullptr && symbol.second <= nearest->second)) continue;
      nearest = &symbol;
    }
    return {nearest->first, address - nearest->second};
  }
};

}  // namespace armature::cosim
