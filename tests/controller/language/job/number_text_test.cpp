#include "controller/language/job/memory/number_text.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/controller/support/random.hpp"

namespace armature::job {
namespace {

std::string printed_again(const std::string& text) {
  const auto number = read_number(text);
  if (!number) return "refused";
  return std::string{number_digits(number->value, number->form, number->exponent, number->exponent_form).view()};
}

TEST(NumberText, PrintsTheCharactersThatItRead) {
  for (const char* text : {"0",
                           "-0",
                           "5",
                           "-5",
                           "+5",
                           "007",
                           "00",
                           "0.000",
                           "-0.000",
                           "12.50",
                           "-1.2500",
                           ".5",
                           "-.25",
                           "00.5",
                           "123456789012345",
                           "0.000000000000001",
                           "1.000000E-02",
                           "1E+5",
                           "2.5e3",
                           "-7.25E-012",
                           "655.35",
                           "99999999.9999999"}) {
    EXPECT_EQ(printed_again(text), text);
  }
}

TEST(NumberText, HasTheValueOfTheCLibrary) {
  for (const char* text : {"0", "-5", "+5", "12.50", ".5", "1.000000E-02", "2.5e3", "-863.111", "178.9297", "655.35"}) {
    EXPECT_EQ(read_number(text)->value, std::strtod(text, nullptr)) << text;
  }
}

TEST(NumberText, RefusesWhatItCouldNotPrintAgain) {
  for (const char* text : {"", "-", "+", ".", "5.", "-.", "1234567890123456", "0.0000000000000001", "1E", "1E+", "1E-0",
                           "1E100", "00000000", "x"}) {
    EXPECT_FALSE(read_number(text)) << text;
  }
}

TEST(NumberText, StopsBehindTheNumber) {
  EXPECT_EQ(read_number("12.5,7")->size, 4U);
  EXPECT_EQ(read_number("3)")->size, 1U);
}

TEST(NumberText, PrintsRandomNumbersAsTheyWere) {
  test::Random random{1507};
  for (int draw = 0; draw < 20'000; ++draw) {
    std::string text = random.integer(0, 3) == 0 ? "-" : "";
    const std::int64_t digits = random.integer(1, 15);
    const std::int64_t whole = random.integer(1, digits);
    for (std::int64_t i = 0; i < digits; ++i) {
      if (i == whole) text += '.';
      const bool zero_leads = i == 0 && whole > 1;
      text += static_cast<char>(random.integer(zero_leads ? '1' : '0', '9'));
    }
    EXPECT_EQ(printed_again(text), text) << "seed 1507, draw " << draw;
  }
}

}  // namespace
}  // namespace armature::job
