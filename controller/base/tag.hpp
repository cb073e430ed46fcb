// The source of a command, and the sender's own number for it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace armature {

// Each source of commands has its own inbox on core 1.
enum class Source : std::uint8_t {
  kScenario,
  kProgram,  // long programs: their moves wait in the inbox while there is no room for them
  kPendant,  // the teach pendant, which the controller reads itself
};
inline constexpr std::size_t kSources = 3;
inline constexpr std::size_t kHostSources = 2;  // the first ones: their commands come from the host

// Packed in 32 bits: the source in the highest 8, the number in the others. The controller only repeats a tag in the
// events of its command.
class Tag {
 public:
  static constexpr std::uint32_t kLargestNumber = 0x00FF'FFFF;

  constexpr Tag() noexcept = default;
  constexpr Tag(std::uint32_t number) noexcept : word_{number & kLargestNumber} {}  // NOLINT: of the scenario
  constexpr Tag(Source source, std::uint32_t number) noexcept
      : word_{static_cast<std::uint32_t>(source) << kNumberBits | (number & kLargestNumber)} {}

  [[nodiscard]] static constexpr Tag from_word(std::uint32_t word) noexcept {
    return {static_cast<Source>(word >> kNumberBits), word};
  }
  [[nodiscard]] constexpr std::uint32_t word() const noexcept { return word_; }

  [[nodiscard]] constexpr Source source() const noexcept { return static_cast<Source>(word_ >> kNumberBits); }
  [[nodiscard]] constexpr std::uint32_t number() const noexcept { return word_ & kLargestNumber; }

  friend constexpr bool operator==(Tag, Tag) noexcept = default;

 private:
  static constexpr int kNumberBits = 24;
  std::uint32_t word_ = 0;
};

}  // namespace armature
