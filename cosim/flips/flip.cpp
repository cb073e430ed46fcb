#include "cosim/flips/flip.hpp"

#include <fmt/format.h>

namespace armature::cosim {

FaultKind fault_of(const Flip& flip) {
  if (flip.offset) return MemoryFlip{.symbol = flip.name, .offset = *flip.offset, .bit = flip.bit};
  return FlopFlip{.flop = flip.name, .bit = flip.bit};
}

std::string keys_of(const Flip& flip) {
  if (flip.offset) {
    return fmt::format("kind=\"memory_flip\",symbol=\"{}\",offset={},bit={}", flip.name, *flip.offset, flip.bit);
  }
  return fmt::format("kind=\"flop_flip\",flop=\"{}\",bit={}", flip.name, flip.bit);
}

std::string block_of(const std::string& flop) {
  const std::size_t begin = flop.find("u_"), end = flop.find('.', begin);
  return begin == std::string::npos || end == std::string::npos ? "pins" : flop.substr(begin, end - begin);
}

}  // namespace armature::cosim
