#include "cosim/iss/arm_core.hpp"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "controller/base/timebase.hpp"
#include "cosim/iss/firmware.hpp"
#include "tests/cosim/iss/scripted_bus.hpp"

namespace armature::cosim::iss {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

constexpr std::uint32_t kCode = 0x0010'0000;
constexpr std::uint32_t kCharge = kCode + 0x800;

// A page with the instructions.
class Program {
 public:
  explicit Program(const std::vector<std::uint32_t>& code) {
    std::copy(code.begin(), code.end(), page_.begin());
    page_[0x800 / 4] = 0xe12fff1e;  // armature_charge: bx lr
  }
  [[nodiscard]] MemoryPiece memory() { return {kCode, page_.data(), sizeof page_}; }
  [[nodiscard]] std::uint32_t word(std::size_t i) const { return page_.at(i); }
  void set(std::size_t i, std::uint32_t word) { page_.at(i) = word; }
  void flip(ArmCore& core, std::size_t i, std::uint32_t mask) {
    page_.at(i) ^= mask;
    core.memory_has_flipped(kCode + 4 * static_cast<std::uint32_t>(i));
  }

 private:
  alignas(4096) std::array<std::uint32_t, 1024> page_{};
};

TEST(ArmCore, AccessesRegistersOfTheLogicByItsBusAndWaitsByWfi) {
  Program program{{
      0xe3a00443,  // mov  r0, #0x43000000
      0xe5901004,  // ldr  r1, [r0, #4]
      0xe5801008,  // str  r1, [r0, #8]
      0xe320f003,  // wfi
      0xe580100c,  // str  r1, [r0, #12]
      0xe320f003,  // wfi
  }};
  ArmCore core{0, kCharge};
  core.map(program.memory());
  ScriptedBus bus;
  bus.wakes_by = {Interrupts::kEvent};
  core.run(kCode, bus);
  EXPECT_THAT(bus.reads, ElementsAre(0x4300'0004u));
  EXPECT_THAT(bus.writes, ElementsAre(Pair(0x4300'0008u, 0x4300'0005u), Pair(0x4300'000cu, 0x4300'0005u)));
  EXPECT_THAT(bus.waits, ElementsAre(Interrupts::kEvent, Interrupts::kEvent));
  EXPECT_EQ(core.pc(), kCode + 24);
}

TEST(ArmCore, ChargesTheWorkOfACall) {
  Program program{{
      0xe3a00002,  // mov r0, #2
      0xe3a01007,  // mov r1, #7
      0xeb0001fc,  // bl  kCharge
      0xe320f003,  // wfi
  }};
  ArmCore core{1, kCharge};
  core.map(program.memory());
  ScriptedBus bus;
  core.run(kCode, bus);
  EXPECT_THAT(bus.charges, ElementsAre(Pair(Work::kPlan, 7)));
}

// Ten clocks for each instruction: 0.75 cycles of the logic.
TEST(ArmCore, LetsTheTimeOfItsInstructionsPassBeforeEachCallOfItsBus) {
  Program program{{
      0xe3a00443,  // mov  r0, #0x43000000
      0xe1a00000,  // nop
      0xe1a00000,  // nop
      0xe5901004,  // ldr  r1, [r0, #4]
      0xe3a00002,  // mov  r0, #2
      0xeb0001f9,  // bl   kCharge
      0xe320f003,  // wfi
  }};
  ArmCore core{0, kCharge, 10.0};
  core.map(program.memory());
  ScriptedBus bus;
  core.run(kCode, bus);
  EXPECT_THAT(bus.times, ElementsAre(4, 5, 6)) << "after runs of 6, 1 and 1 instructions: 4.5, 5.25 and 6 cycles";
  EXPECT_EQ(core.instructions(), 8);
}

TEST(ArmCore, ChargesNoInstructionsOfItsPreparation) {
  Program program{{0xe1a00000, 0xe1a00000, 0xe320f003}};  // nop; nop; wfi
  ArmCore core{0, kCharge, 100.0};
  core.map(program.memory());
  core.prepare(kCode, kCode + 8);
  ScriptedBus bus;
  core.run(kCode + 8, bus);
  EXPECT_EQ(core.instructions(), 1);
  EXPECT_THAT(bus.times, ElementsAre(7));
}

TEST(ArmCore, BothCoresSeeOneMemory) {
  Program program{{
      0xe59f1008,  // ldr r1, [pc, #8]
      0xe2811001,  // add r1, r1, #1
      0xe58f1000,  // str r1, [pc, #0]
      0xe320f003,  // wfi
      0x00000041,
  }};
  std::array<ArmCore, 2> cores{{{0, kCharge}, {1, kCharge}}};
  for (ArmCore& core : cores) {
    core.map(program.memory());
    ScriptedBus bus;
    core.run(kCode, bus);
  }
  EXPECT_EQ(program.word(4), 0x43u);
}

TEST(ArmCore, AnUndefinedInstructionEndsItWithItsPlace) {
  Program program{{0xe1a00000, 0xe7f000f0}};  // nop; udf
  ArmCore core{1, kCharge};
  core.map(program.memory());
  ScriptedBus bus;
  try {
    core.run(kCode, bus);
    FAIL() << "the core went on";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("core 1"));
    EXPECT_THAT(error.what(), HasSubstr("0x10000"));
  }
}

// ---- after a flip of the memory

TEST(ArmCore, ExecutesAnInstructionThatHasFlippedAfterItsFirstExecution) {
  Program program{{
      0xe3a00443,  // mov  r0, #0x43000000
      0xe5801008,  // str  r1, [r0, #8]
      0xe320f003,  // wfi
  }};
  ArmCore core{0, kCharge, 1.5};
  core.map(program.memory());
  ScriptedBus bus;
  core.run(kCode, bus);
  program.flip(core, 1, 4);  // str r1, [r0, #12]
  core.run(kCode, bus);
  EXPECT_THAT(bus.writes, ElementsAre(Pair(0x4300'0008u, 0u), Pair(0x4300'000cu, 0u)));
}

TEST(ArmCore, EndsWhereItCannotContinue) {
  constexpr std::uint32_t kUndefined = 0xe7f000f0;
  constexpr std::uint32_t kSupervisorCall = 0xef000000;
  constexpr std::uint32_t kLoadsFromNowhere = 0xe5921000;  // ldr r1, [r2]
  constexpr std::uint32_t kJumpsToNowhere = 0xe12fff12;    // bx r2
  for (const std::uint32_t instruction : {kUndefined, kSupervisorCall, kLoadsFromNowhere, kJumpsToNowhere}) {
    Program program{{
        0xe3a00443,  // mov  r0, #0x43000000
        0xe3a02102,  // mov  r2, #0x80000000
        instruction,
        0xe5801008,  // str  r1, [r0, #8]
        0xe320f003,  // wfi
    }};
    ArmCore core{0, kCharge, 1.5};
    core.map(program.memory());
    program.flip(core, 100, 1);
    ScriptedBus bus;
    core.run(kCode, bus);
    EXPECT_TRUE(bus.writes.empty()) << instruction;
    EXPECT_TRUE(bus.waits.empty()) << instruction;
  }
}

TEST(ArmCore, ALoopThatCallsNothingTakesTime) {
  Program program{{
      0xe59f1008,  // ldr r1, [pc, #8]
      0xe3510000,  // cmp r1, #0
      0x0afffffc,  // beq to the first one
      0xe320f003,  // wfi
      0x00000000,
  }};
  ArmCore core{0, kCharge, 1.5};
  core.map(program.memory());
  program.flip(core, 100, 1);
  ScriptedBus bus;
  bus.on_pass = [&] {
    if (bus.cycle > 100 * kTickCycles.value()) program.set(4, 1);
  };
  core.run(kCode, bus);
  EXPECT_GT(bus.cycle, 100 * kTickCycles.value());
  EXPECT_EQ(bus.waits.size(), 1U);
}

TEST(ArmCore, ChargesNoWorkThatThereIsNot) {
  Program program{{
      0xe3a0002a,  // mov r0, #42
      0xeb0001fd,  // bl  kCharge
      0xe320f003,  // wfi
  }};
  ArmCore core{0, kCharge, 1.5};
  core.map(program.memory());
  program.flip(core, 100, 1);
  ScriptedBus bus;
  core.run(kCode, bus);
  EXPECT_TRUE(bus.charges.empty());
}

TEST(ArmCore, AccessesAWholeRegisterAtAnyAddress) {
  Program program{{
      0xe3a00443,  // mov  r0, #0x43000000
      0xe5d01005,  // ldrb r1, [r0, #5]
      0xe5c0100a,  // strb r1, [r0, #10]
      0xe320f003,  // wfi
  }};
  ArmCore core{0, kCharge, 1.5};
  core.map(program.memory());
  ScriptedBus bus;
  core.run(kCode, bus);
  EXPECT_THAT(bus.reads, ElementsAre(0x4300'0004u));
  EXPECT_THAT(bus.writes, ElementsAre(Pair(0x4300'0008u, 5u)));
}

#if UC_API_MAJOR == 2 && UC_API_MINOR == 0
TEST(ArmCore, StoresCallTheFunctionsOfTheProgram) {
  Dl_info here{}, found{};
  ASSERT_NE(dladdr(firmware().data(), &here), 0);
  for (const char* const name :
       {"page_collection_lock_arm", "page_collection_unlock_arm", "tb_invalidate_phys_page_fast_arm"}) {
    ASSERT_NE(dladdr(dlsym(RTLD_DEFAULT, name), &found), 0);
    EXPECT_EQ(found.dli_fbase, here.dli_fbase) << name;
  }
}
#endif

TEST(ArmCore, APreparationThatWaitsIsRefused) {
  Program program{{0xe320f003, 0xe1a00000}};  // wfi; nop
  ArmCore core{0, kCharge};
  core.map(program.memory());
  EXPECT_THROW(core.prepare(kCode, kCode + 8), std::runtime_error);
}

}  // namespace
}  // namespace armature::cosim::iss
