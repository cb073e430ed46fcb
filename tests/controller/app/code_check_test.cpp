// The check of the firmware's code: each flipped bit is found in one pass, and the arm stays stopped.
#include "controller/app/code_check.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "tests/controller/support/controller_rig.hpp"

namespace armature {
namespace {

using test::ControllerRig;
using test::kFigure9Deg;

std::vector<std::uint32_t> code_of(std::size_t words) {
  std::vector<std::uint32_t> code(words);
  for (std::size_t i = 0; i < words; ++i) code[i] = 0xE1A0'0000u + static_cast<std::uint32_t>(i % 16) * 0x1001u;
  return code;
}

// The code that the check reads, and core 0, which asks.
class CheckedCode {
 public:
  explicit CheckedCode(std::size_t words) : code{code_of(words)} {}

  // The questions until a change is found; 0 if that takes more than `most` of them.
  std::size_t questions_until_found(std::size_t most = CodeCheck::kParts) {
    for (std::size_t asked = 1; asked <= most; ++asked) {
      channel_.question.fetch_add(1);
      EXPECT_FALSE(check_.execute(bus_));
      if (found()) return asked;
    }
    return 0;
  }
  bool execute() { return check_.execute(bus_); }
  [[nodiscard]] bool found() const { return channel_.code_changed.load(); }
  void forget() { channel_.code_changed = false; }

  std::vector<std::uint32_t> code;

 private:
  LoopChannel channel_;
  test::ModelLogic bus_;
  CodeCheck check_{code, channel_};
};

TEST(CodeCheck, FindsEachFlippedBitInOnePass) {
  for (const std::size_t words : {1u, 7u, 8u, 9u, 63u, 100u}) {
    CheckedCode checked{words};
    for (std::uint32_t& word : checked.code) {
      for (int bit = 0; bit < 32; ++bit) {
        word ^= 1u << bit;
        EXPECT_GT(checked.questions_until_found(), 0u) << words << " words, bit " << bit;
        word ^= 1u << bit;
        checked.forget();
      }
    }
    EXPECT_EQ(checked.questions_until_found(), 0u) << words << " words";
  }
}

// A sum of words alone would not.
TEST(CodeCheck, FindsTwoWordsThatChangedPlaces) {
  CheckedCode checked{64};
  std::swap(checked.code[1], checked.code[2]);
  EXPECT_GT(checked.questions_until_found(), 0u);
}

TEST(CodeCheck, ExecutesOnlyWhenCore0HasAsked) {
  CheckedCode checked{1};
  EXPECT_EQ(checked.questions_until_found(), 0u);
  checked.code[0] ^= 1;
  for (std::size_t i = 0; i < 2 * CodeCheck::kParts; ++i) EXPECT_FALSE(checked.execute());
  EXPECT_FALSE(checked.found());
  EXPECT_GT(checked.questions_until_found(), 0u);
}

TEST(CodeCheck, FindsNothingWithoutCode) {
  CheckedCode checked{0};
  EXPECT_EQ(checked.questions_until_found(3 * CodeCheck::kParts), 0u);
}

// A controller with code that a test changes.
struct CodeRig {
  std::vector<std::uint32_t> code = code_of(10'000);
  std::unique_ptr<Controller> controller;
  ControllerRig rig{test::paper_robot(), {}, {}, [this](host_memory::HostMemory& memory) -> test::ControllerMains {
                      controller = std::make_unique<Controller>(memory, code);
                      return {.core0 = [this](RegisterBus& bus) { controller->core0_main(bus); },
                              .core1 = [this](RegisterBus& bus) { controller->core1_main(bus); }};
                    }};
};

constexpr std::int64_t kFlipped = 10'500;
constexpr std::int64_t kPass = Core1Watch::kPeriod.value() * std::int64_t{CodeCheck::kParts};

TEST(CodeCheck, AChangeStopsTheArmForGood) {
  CodeRig tested;
  ControllerRig& rig = tested.rig;
  rig.move_at(10, kFigure9Deg);
  rig.at(kFlipped, [&] { tested.code[9'999] ^= 0x0100'0000u; });
  rig.submit_at(kFlipped + kPass + 2'000, ClearFault{});
  rig.move_at(kFlipped + kPass + 4'000, {0, 0, 0, 0, 0, 0});
  rig.run(kFlipped + kPass + 6'000);
  ASSERT_EQ(rig.faults.size(), 1u);
  EXPECT_EQ(rig.faults[0].cause, FaultCause::kCodeChanged);
  EXPECT_EQ(rig.faults[0].axis, 0);
  EXPECT_LE(rig.faults[0].tick, Ticks{kFlipped + kPass + 1'000});
  EXPECT_TRUE(rig.faults_cleared.empty());
  EXPECT_EQ(rig.last().state, MotionState::kFault);
  EXPECT_EQ(rig.refusals.size(), 2u);  // ClearFault and the second move
  EXPECT_EQ(rig.last().encoder, rig.row(kFlipped + kPass + 2'000).encoder);
}

// Its commits may be wrong, too.
TEST(CodeCheck, Core0CommitsNothingMoreAfterAChange) {
  CodeRig tested;
  ControllerRig& rig = tested.rig;
  rig.at(kFlipped, [&] { tested.code[0] ^= 1u; });
  rig.run(kFlipped + kPass + 1'000);
  ASSERT_EQ(rig.faults.size(), 1u);
  EXPECT_EQ(rig.last().sequence, rig.row(rig.faults[0].tick.value()).sequence);
}

TEST(CodeCheck, AChangeIsReportedAlsoInAnotherFault) {
  CodeRig tested;
  ControllerRig& rig = tested.rig;
  rig.at(kFlipped - 100, [&] { rig.logic.pins.estop_n = false; });
  rig.at(kFlipped, [&] { tested.code[0] ^= 1u; });
  rig.run(kFlipped + kPass + 1'000);
  ASSERT_EQ(rig.faults.size(), 2u);
  EXPECT_EQ(rig.faults[0].cause, FaultCause::kEstop);
  EXPECT_EQ(rig.faults[1].cause, FaultCause::kCodeChanged);
  EXPECT_EQ(rig.last().fault, FaultCause::kCodeChanged);
}

}  // namespace
}  // namespace armature
