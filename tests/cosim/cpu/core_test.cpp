#include "cosim/cpu/core.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace armature::cosim {
namespace {

constexpr CpuSpec kSpec{.interrupt_entry_cycles = 50,
                        .tick_compute_cycles = 250,
                        .plan_compute_cycles = 2500,
                        .inverse_compute_cycles = 150,
                        .program_step_compute_cycles = 40};

TEST(Core, StartsItsMainAtCycleZero) {
  bool started = false;
  Core core{0, kSpec, [&](RegisterBus&) { started = true; }};
  EXPECT_EQ(core.wakes_at(), Cycles{0});
  core.run_if_due(Cycles{0});
  EXPECT_TRUE(started);
}

TEST(Core, SuspendsInABusAccessUntilItIsCompleted) {
  std::vector<std::uint32_t> read;
  Core core{0, kSpec, [&](RegisterBus& bus) {
              read.push_back(bus.read32(RegAddr{0x40}));
              bus.write32(RegAddr{0x44}, 7);
              read.push_back(99);
            }};
  core.run_if_due(Cycles{0});
  ASSERT_TRUE(core.bus_request());
  EXPECT_FALSE(core.bus_request()->write);
  EXPECT_EQ(core.bus_request()->addr, 0x40u);
  EXPECT_FALSE(core.wakes_at());
  core.complete({BusError::kNone, 1234}, Cycles{20});
  EXPECT_EQ(read, (std::vector<std::uint32_t>{1234}));
  ASSERT_TRUE(core.bus_request());
  EXPECT_TRUE(core.bus_request()->write);
  EXPECT_EQ(core.bus_request()->data, 7u);
  core.complete({}, Cycles{40});
  EXPECT_EQ(read.back(), 99u);
}

TEST(Core, ChargesEachKindOfWorkItsCost) {
  std::vector<std::int64_t> at;
  Core core{0, kSpec, [&](RegisterBus& bus) {
              for (const Work work : {Work::kInterruptEntry, Work::kTick, Work::kPlan}) {
                bus.charge(work);
                at.push_back(bus.now().value());
              }
              bus.charge(Work::kInverse, 5);
              at.push_back(bus.now().value());
              bus.charge(Work::kProgramStep, 2);
              at.push_back(bus.now().value());
            }};
  core.run_if_due(Cycles{0});
  while (core.wakes_at()) {
    core.run_if_due(*core.wakes_at() - Cycles{1});
    core.run_if_due(*core.wakes_at());
  }
  EXPECT_EQ(at, (std::vector<std::int64_t>{50, 300, 2800, 3550, 3630}));
}

TEST(Core, AnInterruptThatIsAlreadyActiveIsReportedAtOnce) {
  Interrupts seen = Interrupts::kNone;
  Core core{0, kSpec, [&](RegisterBus& bus) { seen = bus.wait_for_interrupt(Interrupts::kTimer); }};
  core.set_interrupt_levels(Interrupts::kTimer, Cycles{0});
  core.run_if_due(Cycles{0});
  EXPECT_EQ(seen, Interrupts::kTimer);
}

TEST(Core, SleepsUntilAMaskedInInterruptRises) {
  std::vector<std::int64_t> woken;
  Core core{0, kSpec, [&](RegisterBus& bus) {
              while (bus.wait_for_interrupt(Interrupts::kTimer) != Interrupts::kNone) {
                woken.push_back(bus.now().value());
                bus.charge(Work::kTick);
              }
            }};
  core.run_if_due(Cycles{0});
  core.set_event(Cycles{10});
  EXPECT_TRUE(woken.empty());
  core.set_interrupt_levels(Interrupts::kTimer, Cycles{100});
  EXPECT_EQ(woken, (std::vector<std::int64_t>{100}));
  core.set_interrupt_levels(Interrupts::kNone, Cycles{120});
  core.run_if_due(Cycles{350});
  EXPECT_EQ(core.longest_awake(Cycles{9'999}), Cycles{250});
}

TEST(Core, AComputationThatHasNotEndedCountsAsAwake) {
  Core core{0, kSpec, [&](RegisterBus& bus) {
              while (bus.wait_for_interrupt(Interrupts::kTimer) != Interrupts::kNone) bus.charge(Work::kPlan);
            }};
  core.run_if_due(Cycles{0});
  EXPECT_EQ(core.longest_awake(Cycles{80}), Cycles{0});
  core.set_interrupt_levels(Interrupts::kTimer, Cycles{100});
  EXPECT_EQ(core.longest_awake(Cycles{1'700}), Cycles{1'600});
}

TEST(Core, AnEventIsNotLostAndIsTakenOnce) {
  int events = 0;
  Core core{1, kSpec, [&](RegisterBus& bus) {
              while (bus.wait_for_interrupt(Interrupts::kEvent) != Interrupts::kNone) {
                ++events;
                bus.charge(Work::kPlan);
              }
            }};
  core.run_if_due(Cycles{0});
  core.set_event(Cycles{5});
  EXPECT_EQ(events, 1);
  core.set_event(Cycles{6});  // while it computes
  core.run_if_due(*core.wakes_at());
  EXPECT_EQ(events, 2);
  core.run_if_due(*core.wakes_at());
  EXPECT_EQ(events, 2);
  EXPECT_FALSE(core.wakes_at());
}

TEST(Core, AHaltedCoreAsksForNothingAndNeverWakes) {
  int executed = 0;
  Core core{0, kSpec, [&](RegisterBus& bus) {
              (void)bus.wait_for_interrupt(Interrupts::kTimer);
              (void)bus.read32(RegAddr{0x40});
              ++executed;
            }};
  core.run_if_due(Cycles{0});
  core.set_interrupt_levels(Interrupts::kTimer, Cycles{100});
  ASSERT_TRUE(core.bus_request());
  core.halt(Cycles{130});
  EXPECT_FALSE(core.bus_request());
  EXPECT_FALSE(core.wakes_at());
  core.set_interrupt_levels(Interrupts::kNone, Cycles{200});
  core.set_interrupt_levels(Interrupts::kTimer, Cycles{300});
  core.set_event(Cycles{310});
  core.run_if_due(Cycles{400});
  EXPECT_EQ(executed, 0);
  EXPECT_EQ(core.longest_awake(Cycles{9'999}), Cycles{30}) << "a halted core does not work";
}

TEST(Core, ExecutesNothingMoreOfItsMainAtItsEndInAnyKindOfWait) {
  int executed = 0;
  {
    Core sleeping{0, kSpec, [&](RegisterBus& bus) {
                    (void)bus.wait_for_interrupt(Interrupts::kTimer);
                    ++executed;
                  }};
    Core reading{0, kSpec, [&](RegisterBus& bus) {
                   (void)bus.read32(RegAddr{0});
                   ++executed;
                 }};
    Core computing{0, kSpec, [&](RegisterBus& bus) {
                     bus.charge(Work::kPlan);
                     ++executed;
                   }};
    Core not_started{0, kSpec, [&](RegisterBus&) { ++executed; }};
    for (Core* core : {&sleeping, &reading, &computing}) core->run_if_due(Cycles{0});
  }
  EXPECT_EQ(executed, 0);
}

}  // namespace
}  // namespace armature::cosim
