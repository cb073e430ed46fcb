#include "controller/app/code_check.hpp"

#include <algorithm>
#include <atomic>

namespace armature {

CodeCheck::CodeCheck(std::span<const std::uint32_t> code, LoopChannel& channel) noexcept
    : code_{code}, channel_{channel} {
  for (std::size_t part = 0; part < kParts; ++part) at_start_[part] = sums_of(part);
}

bool CodeCheck::execute(RegisterBus&) noexcept {
  const std::uint32_t question = channel_.question.load(std::memory_order_relaxed);
  if (code_.empty() || question == answered_) return false;
  answered_ = question;
  if (sums_of(next_) != at_start_[next_]) channel_.code_changed.store(true, std::memory_order_relaxed);
  next_ = (next_ + 1) % kParts;
  return false;
}

CodeCheck::Sums CodeCheck::sums_of(std::size_t part) const noexcept {
  const std::size_t words = (code_.size() + kParts - 1) / kParts;
  const std::size_t begin = std::min(part * words, code_.size());
  Sums sums;
  for (const std::uint32_t word : code_.subspan(begin, std::min(words, code_.size() - begin))) {
    sums.words += word;
    sums.sums += sums.words;
  }
  return sums;
}

}  // namespace armature
