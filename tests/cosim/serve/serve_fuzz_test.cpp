// Whatever arrives, each line gets one well-formed answer and the logic continues. Random bytes, and commands that
// random changes have made nearly right; the sanitizer build runs the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>

#include "cosim/net/line_buffer.hpp"
#include "tests/cosim/support/serve_session.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::cosim {
namespace {

using armature::test::SplitMix;
using test::ServeSession;

// Answers `bytes`, which arrive in random pieces; checks what holds for every answer. Returns the answers.
std::string answer_all(ServeSession& session, std::string_view bytes, SplitMix& random) {
  LineBuffer lines{Interpreter::kMaxBatchLine};
  std::string all;
  const auto expected = std::ranges::count(bytes, '\n');
  while (!bytes.empty()) {
    const std::size_t size = std::min<std::size_t>(bytes.size(), 1 + random.below(20000));
    lines.append(bytes.substr(0, size));
    bytes.remove_prefix(size);
    while (const auto line = lines.next()) {
      std::string answer;
      if (line->too_long) {
        session.interpreter.answer_to_long_line(answer);
      } else {
        session.interpreter.answer(line->text, answer, session.stop);
      }
      const std::string_view text = answer;
      EXPECT_LE(text.size(), Interpreter::kMaxBatchAnswer);
      EXPECT_TRUE(text.ends_with('\n'));
      EXPECT_TRUE(text == "ok\n" || text.starts_with("ok ") || text.starts_with("error ")) << text;
      EXPECT_TRUE(std::ranges::all_of(text.substr(0, text.size() - 1), [](char c) { return c >= ' ' && c <= '~'; }));
      all += answer;
    }
  }
  EXPECT_EQ(std::ranges::count(all, '\n'), expected);
  return all;
}

// Every run ends after a few thousand cycles.
ServeSession session_of_short_runs() {
  return ServeSession{make_verilated_fabric(), [] { return true; }};
}

void expect_alive(ServeSession& session) {
  EXPECT_FALSE(session.interpreter.broken());
  EXPECT_EQ(session("r 0x43C10000"), "ok 0x50540106");
}

TEST(ServeFuzz, RandomBytesAreAnsweredLineByLine) {
  constexpr std::uint64_t kSeed = 2021;
  SCOPED_TRACE(kSeed);
  SplitMix random{kSeed};
  ServeSession session = session_of_short_runs();
  for (int round = 0; round < 40; ++round) {
    std::string bytes(random.below(30000), '\0');
    // From few ends of lines, which give lines that are too long, to many.
    const std::uint32_t one_end_in = 1u << random.below(14);
    for (char& c : bytes) c = random.below(one_end_in) == 0 ? '\n' : static_cast<char>(random.below(256));
    answer_all(session, bytes, random);
  }
  expect_alive(session);
}

std::string random_command(SplitMix& random) {
  static constexpr std::string_view kNames[] = {"r",   "w", "run", "run-until-irq", "pin", "time", "help",
                                                "vcd", "x", ""};
  static constexpr std::string_view kWords[] = {"0",          "1",          "0x10",       "300",
                                                "0x42800000", "0x42800004", "0x43C10028", "0x43C10FFC",
                                                "0x43C20080", "4294967295", "0xFFFFFFFF", "4294967296",
                                                "1000000001", "-1",         "0x",         "18446744073709551616",
                                                "step_o",     "gpio_i",     "estop_ni",   "s_axi_x",
                                                "pin",        "a.txt",      "/no/a.vcd",  "'\"\\%s%n{}"};
  std::string line{kNames[random.below(std::size(kNames))]};
  for (std::uint32_t words = random.below(5); words > 0; --words) {
    line += random.below(8) == 0 ? '\t' : ' ';
    line += kWords[random.below(std::size(kWords))];
  }
  if (line.starts_with("vcd")) return line;  // a changed name could be one that is written
  for (std::uint32_t changes = random.below(3); changes > 0 && !line.empty(); --changes) {
    const std::size_t at = random.below(static_cast<std::uint32_t>(line.size()));
    if (random.below(2) == 0) {
      line.erase(at, 1);
    } else {
      line[at] = static_cast<char>(random.below(256));
    }
  }
  return line;
}

TEST(ServeFuzz, NearlyRightCommandsAreAnsweredLineByLine) {
  constexpr std::uint64_t kSeed = 2012;
  SCOPED_TRACE(kSeed);
  SplitMix random{kSeed};
  ServeSession session = session_of_short_runs();
  std::string bytes;
  for (int i = 0; i < 6000; ++i) bytes += random_command(random) + "\n";
  const std::string answers = answer_all(session, bytes, random);
  for (const std::string_view kind :
       {"ok\n", "ok 0x", "error SLVERR", "error DECERR", "error no interrupt", "usage:"}) {
    EXPECT_NE(answers.find(kind), std::string::npos) << kind << " was never seen";
  }
  expect_alive(session);
}

}  // namespace
}  // namespace armature::cosim
