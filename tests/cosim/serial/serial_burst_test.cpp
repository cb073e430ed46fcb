#include "cosim/serial/serial_burst.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string_view>

namespace armature::cosim {
namespace {

// Of 10 bits, 5000 cycles a bit.
constexpr SerialFormat kFormat{.baud = 10'000};
constexpr std::int64_t kCharacter = 50'000;

SerialEvent character(std::int64_t at, char byte) {
  SerialEvent event;
  event.at = Cycles{at};
  event.byte = static_cast<std::uint8_t>(byte);
  return event;
}

// One after the other without a pause.
void add_all(SerialBurst& burst, std::string_view bytes) {
  for (std::int64_t at = 0; const char byte : bytes) burst.add(character(at += kCharacter, byte));
}

TEST(SerialBurst, GrowsUntilAPauseOfMoreThanFourCharacters) {
  SerialBurst burst{kFormat, 24};
  EXPECT_EQ(burst.text(), "");
  burst.add(character(0, 'a'));
  burst.add(character(kCharacter, 'b'));
  burst.add(character(6 * kCharacter, 'c'));
  EXPECT_EQ(burst.text(), "abc");
  burst.add(character(11 * kCharacter + 1, 'd'));
  EXPECT_EQ(burst.text(), "d");
}

TEST(SerialBurst, APauseIsMeasuredInCharactersOfTheFormat) {
  const SerialFormat longer{.baud = 10'000, .parity = SerialParity::kEven, .stop_half_bits = 4};  // 12 bits
  SerialBurst burst{longer, 24};
  burst.add(character(0, 'a'));
  burst.add(character(6 * kCharacter, 'b'));
  EXPECT_EQ(burst.text(), "ab");
  burst.add(character(12 * kCharacter + 1, 'c'));
  EXPECT_EQ(burst.text(), "c");
}

TEST(SerialBurst, KeepsTheLastCharactersThatFitAsAWhole) {
  SerialBurst burst{kFormat, 6};
  add_all(burst, "abcdefgh");
  EXPECT_EQ(burst.text(), "cdefgh");
  SerialBurst escapes{kFormat, 6};
  add_all(escapes, "\x80y\r");
  EXPECT_EQ(escapes.text(), "y\\r");
}

TEST(SerialBurst, WritesCharactersAsTheLogDoes) {
  SerialBurst burst{kFormat, 24};
  add_all(burst, "A\n\\,\x7F");
  EXPECT_EQ(burst.text(), "A\\n\\\\\\x2C\\x7F");
}

}  // namespace
}  // namespace armature::cosim
