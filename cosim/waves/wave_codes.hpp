// From the code of a signal in a VCD file to a number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace armature::cosim {

class WaveCodes {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  // The number of this code: 0 for the first one, then counting up. A code that is known keeps its number.
  std::uint32_t add(std::string_view code);
  // kNone: there is no such code.
  [[nodiscard]] std::uint32_t find(std::string_view code) const;

  [[nodiscard]] std::uint32_t size() const { return size_; }

 private:
  // A short code is a number whose digits are the 94 printable characters: its place in by_place_. Others have none.
  [[nodiscard]] static std::optional<std::size_t> place(std::string_view code);

  std::vector<std::uint32_t> by_place_;
  std::map<std::string, std::uint32_t, std::less<>> others_;
  std::uint32_t size_ = 0;
};

}  // namespace armature::cosim
