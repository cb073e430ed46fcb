#include "cosim/net/token.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

namespace armature::cosim {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

const std::string kToken = "0123456789abcdef0123456789abcdef";

TEST(Token, Has128BitsInHexadecimalDigitsAndIsAnotherEachTime) {
  std::set<std::string> seen;
  for (int i = 0; i < 1000; ++i) {
    const std::string token = random_token();
    EXPECT_THAT(token, MatchesRegex("[0-9a-f]{32}"));
    seen.insert(token);
  }
  EXPECT_EQ(seen.size(), 1000u);
}

TEST(Token, AdmitsWhoGivesIt) {
  for (const std::string& line : {"token " + kToken, "token " + kToken + "\r", "  token\t" + kToken + "  "}) {
    const Admission admission = check_first_line(line, kToken);
    EXPECT_TRUE(admission.admitted) << line;
    EXPECT_EQ(admission.answer, "ok\n") << line;
  }
}

TEST(Token, RefusesEveryOtherFirstLine) {
  for (const std::string& line :
       {std::string{}, std::string{"time"}, std::string{"GET / HTTP/1.1\r"}, std::string{"vcd a.vcd"}, kToken,
        "token" + kToken, "TOKEN " + kToken, "x token " + kToken, std::string{"token"}, std::string{"token "},
        "token " + kToken.substr(1), "token " + kToken + "0", "token " + kToken + " time",
        std::string{"token 1123456789abcdef0123456789abcdef"}, std::string{"token 0123456789abcdef0123456789abcdee"},
        std::string{"token 0123456789ABCDEF0123456789ABCDEF"}, "token " + kToken + std::string{'\0'}}) {
    const Admission admission = check_first_line(line, kToken);
    EXPECT_FALSE(admission.admitted) << line;
    EXPECT_THAT(std::string{admission.answer},
                AllOf(StartsWith("error "), HasSubstr("the first line must be 'token TOKEN'"), EndsWith("closed\n")))
        << line;
  }
}

TEST(Token, WithoutOneEveryClientIsAdmittedAndTheLineIsTaken) {
  for (const std::string& line : {"token " + kToken, std::string{"token"}, std::string{"token x y\r"}}) {
    EXPECT_TRUE(check_first_line(line, std::nullopt).admitted) << line;
    EXPECT_EQ(check_first_line(line, std::nullopt).answer, "ok\n") << line;
  }
  for (const std::string line : {"time", "", "tokens", "r 0"}) {
    EXPECT_TRUE(check_first_line(line, std::nullopt).admitted) << line;
    EXPECT_EQ(check_first_line(line, std::nullopt).answer, "") << line << " is a command";
  }
}

}  // namespace
}  // namespace armature::cosim
