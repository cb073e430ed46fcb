#include "cosim/soc/pin_soc.hpp"

#include <gtest/gtest.h>

#include "controller/regs/soc_map.hpp"
#include "cosim/kernel/scenario_soc.hpp"

namespace armature::cosim {
namespace {

constexpr std::uint32_t kTcsr0 = regs::soc::kAxiTimerBase;
constexpr std::uint32_t kTlr0 = regs::soc::kAxiTimerBase + 4;
constexpr std::uint32_t kLoad = 0x20;
constexpr std::uint32_t kCountDownWithInterrupt = 0xD2;
constexpr Cycles kLong{10'000};

std::unique_ptr<Soc> chip() {
  return make_soc(Scenario{});
}

void write(Soc& soc, std::uint32_t addr, std::uint32_t data) {
  soc.start({.write = true, .addr = addr, .data = data});
  soc.advance(soc.now() + kLong, StopOn::kAccess);
  const auto response = soc.pop_response();
  ASSERT_TRUE(response);
  EXPECT_EQ(response->error, BusError::kNone);
}

TEST(PinSoc, AnAccessEndsInTheSameCycleHoweverTheTimeIsCut) {
  const auto at_once = chip();
  at_once->start({.write = true, .addr = kTlr0, .data = 5});
  EXPECT_FALSE(at_once->advance(kLong, StopOn::kAccess));
  const auto piecewise = chip();
  piecewise->start({.write = true, .addr = kTlr0, .data = 5});
  while (!piecewise->pop_response()) {
    EXPECT_FALSE(piecewise->idle());
    piecewise->advance(piecewise->now() + Cycles{1}, StopOn::kPinChange);
  }
  EXPECT_EQ(at_once->now(), piecewise->now());
  EXPECT_LT(at_once->now(), Cycles{30});
}

TEST(PinSoc, IsIdleOnceTheResponseIsTaken) {
  const auto soc = chip();
  EXPECT_TRUE(soc->idle());
  soc->start({.write = false, .addr = kTlr0});
  EXPECT_FALSE(soc->pop_response());
  soc->advance(kLong, StopOn::kAccess);
  EXPECT_FALSE(soc->idle());
  EXPECT_TRUE(soc->pop_response());
  EXPECT_FALSE(soc->pop_response());
  EXPECT_TRUE(soc->idle());
}

std::unique_ptr<Soc> chip_with_running_timer(std::uint32_t load) {
  auto soc = chip();
  write(*soc, kTlr0, load);
  write(*soc, kTcsr0, kLoad);
  write(*soc, kTcsr0, kCountDownWithInterrupt);
  return soc;
}

TEST(PinSoc, StopsAtTheFirstChangeOfWhatIsNamed) {
  const auto for_pins = chip_with_running_timer(498);
  const SocOutputs before = for_pins->outputs();
  EXPECT_TRUE(for_pins->advance(kLong, StopOn::kPinChange));
  EXPECT_NE(for_pins->outputs(), before);

  const auto for_interrupts = chip_with_running_timer(498);
  EXPECT_TRUE(for_interrupts->advance(kLong, StopOn::kInterrupt));
  EXPECT_EQ(for_interrupts->interrupts(), 1u << regs::soc::kAxiTimerIrq);
  EXPECT_LE(for_pins->now(), for_interrupts->now());
  EXPECT_LT(for_interrupts->now(), Cycles{700});
}

TEST(PinSoc, RunsToTheLimitWhenNothingIsNamed) {
  const auto soc = chip_with_running_timer(98);
  EXPECT_FALSE(soc->advance(Cycles{5'000}, StopOn::kAccess));
  EXPECT_EQ(soc->now(), Cycles{5'000});
  EXPECT_NE(soc->interrupts(), 0);
}

TEST(PinSoc, TimeGoesOnAndNothingElseWhileTheClockIsStopped) {
  const auto soc = chip_with_running_timer(98);
  const auto twin = chip_with_running_timer(98);
  const SocOutputs before = soc->outputs();
  const Cycles from = soc->now();
  soc->start({.write = false, .addr = kTlr0});
  twin->start({.write = false, .addr = kTlr0});
  soc->set_clock_running(false);
  EXPECT_FALSE(soc->advance(from + kLong, StopOn::kPinChange));
  EXPECT_EQ(soc->now(), from + kLong);
  EXPECT_EQ(soc->outputs(), before);
  EXPECT_FALSE(soc->pop_response());
  soc->set_clock_running(true);
  // The logic continues as if there had been no stop, once the access is over.
  for (const auto& chip : {soc.get(), twin.get()}) {
    while (!chip->pop_response()) chip->advance(chip->now() + Cycles{1}, StopOn::kAccess);
  }
  EXPECT_GT(soc->now(), from + kLong);
  EXPECT_TRUE(soc->advance(soc->now() + kLong, StopOn::kPinChange));
}

TEST(PinSoc, DoesNothingWhenTheLimitIsReached) {
  const auto soc = chip();
  soc->advance(Cycles{7}, StopOn::kAccess);
  EXPECT_FALSE(soc->advance(Cycles{7}, StopOn::kPinChange));
  EXPECT_FALSE(soc->advance(Cycles{3}, StopOn::kPinChange));
  EXPECT_EQ(soc->now(), Cycles{7});
}

}  // namespace
}  // namespace armature::cosim
