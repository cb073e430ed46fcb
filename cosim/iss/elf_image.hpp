// A 32-bit little-endian ARM program in the ELF format: what is loaded where, and the addresses of its symbols.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace armature::cosim::iss {

class ElfImage {
 public:
  struct Segment {
    std::uint32_t address = 0;  // physical
    std::span<const std::uint8_t> bytes;
  };

  // `file` must outlive the image. Throws std::runtime_error when it is not such a program, or is cut off.
  explicit ElfImage(std::span<const std::uint8_t> file);

  [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }
  // The addresses of the global symbols.
  using Symbols = std::map<std::string, std::uint32_t, std::less<>>;
  [[nodiscard]] const Symbols& symbols() const { return symbols_; }
  // The address of a symbol. Throws std::runtime_error when there is none.
  [[nodiscard]] std::uint32_t symbol(std::string_view name) const;

 private:
  std::vector<Segment> segments_;
  Symbols symbols_;
};

}  // namespace armature::cosim::iss
