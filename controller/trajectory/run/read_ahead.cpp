#include "controller/trajectory/run/read_ahead.hpp"

#include <cstddef>

namespace armature {
namespace {

constexpr std::size_t kLine = 32;  // bytes; no processor has shorter lines
constexpr std::size_t kFirstSegments = 2, kFirstPoints = 8;

void ask_for(const void* memory, std::size_t bytes) {
  const auto* first = static_cast<const std::byte*>(memory);
  for (std::size_t at = 0; at < bytes; at += kLine) __builtin_prefetch(first + at);
  __builtin_prefetch(first + bytes - 1);
}

std::size_t bytes_between(const void* begin, const void* end) {
  return static_cast<std::size_t>(static_cast<const char*>(end) - static_cast<const char*>(begin));
}

// Those that a binary search reads on its way to the first of `count`. `address(i)`: where it reads.
template <class Address>
void ask_for_search(std::size_t count, Address address) {
  for (std::size_t i = count / 2; i > 0; i /= 2) __builtin_prefetch(address(i));
}

}  // namespace

void ReadAhead::advance(const CartesianPlan& next) noexcept {
  if (plan_ != &next) part_ = 0;
  plan_ = &next;
  switch (part_++) {
    case 0:
      ask_for(&next, bytes_between(&next, &next.segments));
      ask_for(&next.count, sizeof next.count);
      __builtin_prefetch(&next.bends.count);
      ask_for(&next.duration, bytes_between(&next.duration, &next + 1));
      break;
    case 1:
      ask_for(next.segments.data(), kFirstSegments * sizeof(CartesianSegment));
      ask_for_search(next.count, [&](std::size_t i) { return &next.segments[i].from; });
      break;
    case 2:
      ask_for(&next.table[0], kFirstPoints * sizeof(TimeTable::Point));
      ask_for_search(next.table.size(), [&](std::size_t i) { return &next.table[i]; });
      break;
    default:
      part_ = 3;
  }
}

}  // namespace armature
