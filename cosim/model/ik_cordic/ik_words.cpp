#include "cosim/model/ik_cordic/ik_words.hpp"

namespace armature::cosim::model::ik {

std::int64_t Widths::root_of_product(std::int64_t a, std::int64_t b) {
  __extension__ using Wide = unsigned __int128;
  const Wide square = static_cast<Wide>(a) * static_cast<Wide>(b);
  exceeded_ = exceeded_ || (square >> (2 * kRootBits)) != 0;
  std::int64_t root = 0;
  for (int bit = kRootBits - 1; bit >= 0; --bit) {
    const std::int64_t tried = root | std::int64_t{1} << bit;
    if (static_cast<Wide>(tried) * static_cast<Wide>(tried) <= square) root = tried;
  }
  return root;
}

}  // namespace armature::cosim::model::ik
