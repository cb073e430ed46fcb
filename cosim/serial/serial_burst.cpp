#include "cosim/serial/serial_burst.hpp"

#include <cstdint>

#include "controller/base/timebase.hpp"
#include "cosim/serial/serial_log.hpp"

namespace armature::cosim {
namespace {

constexpr int kPauseCharacters = 4;

}  // namespace

void SerialBurst::add(const SerialEvent& event) {
  if (is_after_pause(event.at)) bytes_.clear();
  last_at_ = event.at;
  if (bytes_.size() == longest_) bytes_.erase(0, 1);
  bytes_ += static_cast<char>(event.byte);
}

// Without a pause the times of two characters differ by the length of one.
bool SerialBurst::is_after_pause(Cycles at) const {
  if (!last_at_) return false;
  const std::int64_t half_bits = (1 + kPauseCharacters) * std::int64_t{format_.half_bits()};
  return (at - *last_at_).value() * 2 * format_.baud > half_bits * kClkFreqHz;
}

std::string SerialBurst::text() const {
  std::string text;
  for (auto byte = bytes_.rbegin(); byte != bytes_.rend(); ++byte) {
    const std::string character = serial_text(static_cast<std::uint8_t>(*byte));
    if (text.size() + character.size() > longest_) break;
    text.insert(0, character);
  }
  return text;
}

}  // namespace armature::cosim
