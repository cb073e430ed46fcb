#include "cosim/fabric/flops/flops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace armature::cosim {
namespace {

constexpr int kBitsOfByte = 8;

unsigned char* byte_of(unsigned char* data, int bit) {
  return data + bit / kBitsOfByte;
}
unsigned mask_of(int bit) {
  return 1u << (bit % kBitsOfByte);
}
void invert(unsigned char* byte, unsigned mask) {
  *byte = static_cast<unsigned char>(*byte ^ mask);
}

bool is_memory(std::string_view name) {
  return name.ends_with(".memory");
}

}  // namespace

Flops::Flops(const std::vector<FlopPlace>& places, std::function<void()> settle) : settle_{std::move(settle)} {
  std::vector<std::pair<Flop, unsigned char*>> found;
  for (const FlopPlace& place : places) {
    if (is_memory(place.name)) continue;
    for (std::size_t i = 0; i < place.elements; ++i) {
      auto* const data = static_cast<unsigned char*>(place.data) + i * (place.size / place.elements);
      const std::string name = place.elements == 1 ? place.name : fmt::format("{}[{}]", place.name, i);
      if (keeps_its_value(data, 1)) found.push_back({{name, static_cast<int>(place.bits)}, data});
    }
  }
  std::ranges::sort(found, {}, [](const auto& one) -> const std::string& { return one.first.name; });
  for (auto& [flop, data] : found) {
    list_.push_back(std::move(flop));
    data_.push_back(data);
  }
}

bool Flops::keeps_its_value(unsigned char* byte, unsigned mask) const {
  const unsigned char before = *byte;
  invert(byte, mask);
  settle_();
  const bool keeps = ((*byte ^ before) & mask) != 0;
  *byte = before;
  settle_();
  return keeps;
}

bool Flops::flip(std::string_view name, int bit) {
  const auto found = std::ranges::lower_bound(list_, name, {}, &Flop::name);
  if (found == list_.end() || found->name != name || bit < 0 || bit >= found->bits) return false;
  invert(byte_of(data_[static_cast<std::size_t>(found - list_.begin())], bit), mask_of(bit));
  settle_();
  return true;
}

std::uint64_t Flops::digest() const {
  // FNV-1a over bytes.
  std::uint64_t digest = 0xCBF2'9CE4'8422'2325;
  for (std::size_t i = 0; i < list_.size(); ++i) {
    for (int bit = 0; bit < list_[i].bits; bit += kBitsOfByte) {
      digest = (digest ^ *byte_of(data_[i], bit)) * 0x100'0000'01B3;
    }
  }
  return digest;
}

}  // namespace armature::cosim
