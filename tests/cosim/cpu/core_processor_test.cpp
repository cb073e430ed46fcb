// Program errors of the fault script at a processor: stray accesses, and a core that stops.
#include "cosim/cpu/core_processor.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace armature::cosim {
namespace {

constexpr Cycles kNow{100};

// Core 0 does nothing; core 1 reads this register again and again.
class Polling final : public CoreProgram {
 public:
  void main(int core, CoreBus& bus) override {
    while (core == 1) (void)bus.read32(RegAddr{0x40});
  }
};

struct Bench {
  CoreProcessor processor{std::make_unique<Polling>(), CpuSpec{}};

  // Ends the access under way, if there is one.
  std::optional<Processor::Access> complete(std::uint32_t data) {
    processor.advance(kNow);
    const std::optional<Processor::Access> access = processor.next_access();
    if (access) processor.complete(*access, {.error = BusError::kNone, .data = data}, kNow);
    return access;
  }
};

TEST(CoreProcessor, FlipsOneBitOfARegisterByAReadAndAWriteBeforeOtherAccesses) {
  Bench bench;
  bench.processor.advance(kNow);
  bench.processor.flip_astray(0x1000, 0b100);
  const auto read = bench.complete(0b1110);
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->stray);
  EXPECT_FALSE(read->request.write);
  EXPECT_EQ(read->request.addr, 0x1000u);
  const auto write = bench.complete(0);
  ASSERT_TRUE(write);
  EXPECT_TRUE(write->stray);
  EXPECT_TRUE(write->request.write);
  EXPECT_EQ(write->request.addr, 0x1000u);
  EXPECT_EQ(write->request.data, 0b1010u);
  const auto own = bench.complete(0);
  ASSERT_TRUE(own);
  EXPECT_FALSE(own->stray);
  EXPECT_EQ(own->request.addr, 0x40u);
}

TEST(CoreProcessor, AnErrorResponseToAStrayAccessStopsCoreOneAndDropsTheAccess) {
  Bench bench;
  bench.processor.advance(kNow);
  bench.processor.flip_astray(0x1000, 1);
  const auto read = bench.processor.next_access();
  ASSERT_TRUE(read);
  bench.processor.abort(*read, kNow);
  EXPECT_EQ(bench.processor.core_state(1), CoreState::kHalted);
  EXPECT_FALSE(bench.processor.next_access()) << "no write follows";
}

TEST(CoreProcessor, ACoreThatStopsMakesNoAccessAndWakesNoMore) {
  Bench bench;
  ASSERT_TRUE(bench.complete(0));
  bench.processor.advance(kNow);
  const auto under_way = bench.processor.next_access();
  ASSERT_TRUE(under_way);
  bench.processor.stop_core_one(kNow);
  EXPECT_EQ(bench.processor.core_state(1), CoreState::kHalted);
  bench.processor.complete(*under_way, {}, kNow);  // its response is lost
  bench.processor.notify(kNow);
  bench.processor.set_interrupts(0xFF, kNow);
  bench.processor.advance(kNow + Cycles{10});
  EXPECT_FALSE(bench.processor.next_access());
  EXPECT_FALSE(bench.processor.next_event());
  // Errors of the program come nevertheless.
  bench.processor.write_astray(0x2000, 7);
  EXPECT_TRUE(bench.processor.next_access());
}

}  // namespace
}  // namespace armature::cosim
