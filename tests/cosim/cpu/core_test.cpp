#include "cosim/cpu/core.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
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

TEST(Core, ChargesOfInstructionsTheirTimeAndOfWorkWhatAFaultAdds) {
  CpuSpec spec = without_costs(kSpec);
  spec.cpi = 1.5;
  std::vector<std::int64_t> at;
  Core core{0, spec, [&](CoreBus& bus) {
              for (const std::int64_t duration : {0, 7, 30}) {
                bus.pass(Cycles{duration});
                bus.charge(Work::kTick);
                at.push_back(bus.now().value());
              }
            }};
  core.run_if_due(Cycles{0});
  EXPECT_EQ(at, (std::vector<std::int64_t>{0})) << "no time, no wait";
  EXPECT_EQ(core.wakes_at(), Cycles{7});
  core.run_if_due(Cycles{7});
  core.set_tick_compute(500);
  while (core.wakes_at()) core.run_if_due(*core.wakes_at());
  EXPECT_EQ(at, (std::vector<std::int64_t>{0, 7, 537}));
}

TEST(Core, AnInterruptThatIsAlreadyActiveIsReportedAtOnce) {
  Interrupts seen = Interrupts::kNone;
  Core core{0, kSpec, [&](RegisterBus& bus) { seen = bus.wait_for_interrupt(Interrupts::kTimer); }};
  core.set_interrupt_levels(Interrupts::kTimer);
  core.wake_if_interrupted(Cycles{0});
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
  core.set_interrupt_levels(Interrupts::kTimer);
  core.wake_if_interrupted(Cycles{100});
  EXPECT_EQ(woken, (std::vector<std::int64_t>{100}));
  core.set_interrupt_levels(Interrupts::kNone);
  core.wake_if_interrupted(Cycles{120});
  core.run_if_due(Cycles{350});
  EXPECT_EQ(core.longest_awake(Cycles{9'999}), Cycles{250});
}

TEST(Core, AComputationThatHasNotEndedCountsAsAwake) {
  Core core{0, kSpec, [&](RegisterBus& bus) {
              while (bus.wait_for_interrupt(Interrupts::kTimer) != Interrupts::kNone) bus.charge(Work::kPlan);
            }};
  core.run_if_due(Cycles{0});
  EXPECT_EQ(core.longest_awake(Cycles{80}), Cycles{0});
  core.set_interrupt_levels(Interrupts::kTimer);
  core.wake_if_interrupted(Cycles{100});
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
  core.set_interrupt_levels(Interrupts::kTimer);
  core.wake_if_interrupted(Cycles{100});
  ASSERT_TRUE(core.bus_request());
  core.halt(Cycles{130});
  EXPECT_FALSE(core.bus_request());
  EXPECT_FALSE(core.wakes_at());
  core.set_interrupt_levels(Interrupts::kNone);
  core.wake_if_interrupted(Cycles{200});
  core.set_interrupt_levels(Interrupts::kTimer);
  core.wake_if_interrupted(Cycles{300});
  core.set_event(Cycles{310});
  core.run_if_due(Cycles{400});
  EXPECT_EQ(executed, 0);
  EXPECT_EQ(core.longest_awake(Cycles{9'999}), Cycles{30}) << "a halted core does not work";
}

TEST(Core, PassesOnWhatEndsItsMainAndHalts) {
  Core core{0, kSpec, [](RegisterBus& bus) {
              (void)bus.wait_for_interrupt(Interrupts::kEvent);
              throw std::runtime_error{"undefined instruction"};
            }};
  core.run_if_due(Cycles{0});
  EXPECT_THROW(core.set_event(Cycles{7}), std::runtime_error);
  EXPECT_EQ(core.state(), CoreState::kHalted);
  core.set_event(Cycles{9});
  EXPECT_FALSE(core.wakes_at());
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

// A simulation in which nothing else happens before the cycle `quiet_until`, with accesses of 10 cycles.
struct QuietSimulation final : RunAhead {
  Cycles quiet_until{};
  bool unread = false;
  std::vector<std::int64_t> accesses{}, caught_up{};

  Cycles horizon() const override { return quiet_until; }
  Cycles pass_time(Cycles) override { return quiet_until; }
  bool host_must_read() const override { return unread; }
  void catch_up(Cycles now) override { caught_up.push_back(now.value()); }
  Outcome try_access(const BusRequest&, TimeAhead& time) override {
    const Cycles ends = time.now + Cycles{10};
    if (ends >= time.horizon) return {};
    accesses.push_back(time.now.value());
    time.now = ends;
    return {.access = Access::kDone, .data = 5};
  }
};

TEST(Core, RunsAheadUpToTheHorizon) {
  QuietSimulation simulation;
  simulation.quiet_until = Cycles{300};
  Core other{1, kSpec, [](RegisterBus& bus) { (void)bus.wait_for_interrupt(Interrupts::kTimer); }};
  Core core{0, kSpec, [](RegisterBus& bus) {
              EXPECT_EQ(bus.read32(RegAddr{0}), 5u);
              bus.charge(Work::kTick);
              bus.write32(RegAddr{0}, 1);
              bus.write32(RegAddr{0}, 2);
              bus.write32(RegAddr{0}, 3);
            }};
  core.run_ahead(simulation, other);
  other.run_if_due(Cycles{0});
  core.run_if_due(Cycles{0});
  EXPECT_EQ(simulation.accesses, (std::vector<std::int64_t>{0, 260, 270, 280}));
  EXPECT_FALSE(core.wakes_at()) << "the main has ended";
}

TEST(Core, WaitsAtTheHorizonInTheCycleInWhichItIs) {
  QuietSimulation simulation;
  simulation.quiet_until = Cycles{260};
  Core other{1, kSpec, [](RegisterBus& bus) { (void)bus.wait_for_interrupt(Interrupts::kTimer); }};
  Core core{0, kSpec, [](RegisterBus& bus) {
              bus.charge(Work::kTick);
              bus.write32(RegAddr{0}, 1);
              bus.write32(RegAddr{0}, 2);
            }};
  core.run_ahead(simulation, other);
  other.run_if_due(Cycles{0});
  core.run_if_due(Cycles{0});
  EXPECT_EQ(simulation.caught_up, (std::vector<std::int64_t>{250}));
  EXPECT_EQ(core.wakes_at(), Cycles{250}) << "its next access begins there";
  EXPECT_FALSE(core.bus_request());
  simulation.quiet_until = Cycles{};
  core.run_if_due(Cycles{250});
  ASSERT_TRUE(core.bus_request());
  EXPECT_EQ(core.bus_request()->data, 1u);
}

TEST(Core, DoesNotRunAheadOfTheOtherCoreOrOfAnUnreadEventOrWithoutTime) {
  const auto runs_ahead = [](bool other_computes, bool unread, std::int64_t tick_compute) {
    QuietSimulation simulation;
    simulation.quiet_until = Cycles{10'000};
    simulation.unread = unread;
    Core other{1, kSpec, [&](RegisterBus& bus) {
                 if (other_computes) bus.charge(Work::kProgramStep);
                 (void)bus.wait_for_interrupt(Interrupts::kTimer);
               }};
    Core core{0, kSpec, [](RegisterBus& bus) { bus.charge(Work::kInterruptEntry); }};
    core.set_tick_compute(tick_compute);
    core.run_ahead(simulation, other);
    other.run_if_due(Cycles{0});
    core.run_if_due(Cycles{0});
    return !core.wakes_at();
  };
  EXPECT_TRUE(runs_ahead(false, false, 250));
  EXPECT_FALSE(runs_ahead(true, false, 250)) << "the other core wakes after 40 cycles, before 50";
  EXPECT_FALSE(runs_ahead(false, true, 250));
  EXPECT_FALSE(runs_ahead(false, false, 0));
}

}  // namespace
}  // namespace armature::cosim
