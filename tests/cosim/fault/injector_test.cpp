// Each kind of fault acts where it should and nowhere else, until its end.
#include "cosim/fault/injector.hpp"
#include "controller/base/words.hpp"
#include "controller/regs/soc_map.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/fake_fabric.hpp"
#include "tests/support/pin_soc.hpp"

namespace armature::cosim {
namespace {

constexpr Cycles kNow{1000};

// Records what a fault does to it; faults must not call the rest.
class FaultyProcessor final : public Processor {
 public:
  std::vector<Cycles> tick_compute;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> stray_writes;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> flips;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> memory_flips;
  CoreMemory core_memory{.parts = {{"part", 0x100, 0x10}}, .symbols = {{"here", 0x100}}};
  std::optional<Cycles> core_one_stopped;

  void set_tick_compute(Cycles cost) override { tick_compute.push_back(cost); }
  void write_astray(std::uint32_t addr, std::uint32_t data) override { stray_writes.emplace_back(addr, data); }
  void flip_astray(std::uint32_t addr, std::uint32_t mask) override { flips.emplace_back(addr, mask); }
  const CoreMemory& memory() const override { return core_memory; }
  void flip_memory(std::uint32_t addr, std::uint32_t mask) override { memory_flips.emplace_back(addr, mask); }
  void stop_core_one(Cycles now) override { core_one_stopped = now; }

  void run_ahead(RunAhead&) override { ADD_FAILURE(); }
  void notify(Cycles) override { ADD_FAILURE(); }
  std::optional<Cycles> next_event() const override { return std::nullopt; }
  void advance(Cycles) override { ADD_FAILURE(); }
  std::optional<Access> next_access() const override { return std::nullopt; }
  void complete(const Access&, const BusResponse&, Cycles) override { ADD_FAILURE(); }
  void abort(const Access&, Cycles) override { ADD_FAILURE(); }
  void set_interrupts(std::uint8_t, Cycles) override { ADD_FAILURE(); }
  Cycles worst_tick(Cycles) const override { return {}; }
  void reset_worst_tick() override { ADD_FAILURE(); }
  std::int64_t instructions(int) const override { return 0; }
  Cycles awake(int, Cycles) const override { return {}; }
  std::optional<std::uint64_t> digest() const override { return std::nullopt; }
  CoreState core_state(int) const override { return {}; }
};

struct Bench {
  Plant plant{RobotSpec{}};
  FaultyProcessor processor;
  std::unique_ptr<Soc> soc = test::pin_soc(std::make_unique<FakeFabric>());
  FaultInjector injector{{.plant = plant, .processor = processor, .soc = *soc}};

  [[nodiscard]] PerAxis<std::int64_t> pulses_to_drop() const {
    PerAxis<std::int64_t> counts{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) counts[axis] = plant.pulses_to_drop(axis);
    return counts;
  }
  [[nodiscard]] SocInputs pins() const {
    SocInputs pins = plant.inputs();
    injector.apply_to(pins);
    return pins;
  }
};

const SocInputs kPinsAtRest = Bench{}.pins();
constexpr PerAxis<std::int64_t> kNoPulses{};

TEST(FaultInjector, DoesNothingBeforeAFault) {
  const Bench bench;
  EXPECT_EQ(bench.pins(), bench.plant.inputs());
  EXPECT_TRUE(bench.pins().estop_n);
  EXPECT_EQ(bench.pulses_to_drop(), kNoPulses);
}

TEST(FaultInjector, LosesPulsesOfTheNamedDriveOnly) {
  Bench bench;
  bench.injector.begin(PulseLoss{.axis = 3, .count = 500}, kNow);
  EXPECT_EQ(bench.pulses_to_drop(), (PerAxis<std::int64_t>{0, 0, 500, 0, 0, 0}));
  EXPECT_TRUE(bench.processor.tick_compute.empty());
  EXPECT_EQ(bench.pins(), kPinsAtRest);
}

TEST(FaultInjector, ChangesTheTimeThatCoreZeroComputes) {
  Bench bench;
  bench.injector.begin(SlowCore{.compute_us = 60}, kNow);
  EXPECT_EQ(bench.processor.tick_compute, (std::vector{Cycles{3000}}));
  EXPECT_EQ(bench.pulses_to_drop(), kNoPulses);
  EXPECT_EQ(bench.pins(), kPinsAtRest);
}

TEST(FaultInjector, HoldsTheEmergencyStopAndNoOtherPinUntilItsEnd) {
  Bench bench;
  bench.injector.begin(Estop{.duration_s = 0.1}, kNow);
  SocInputs stopped = kPinsAtRest;
  stopped.estop_n = false;
  EXPECT_EQ(bench.pins(), stopped);
  EXPECT_EQ(bench.pulses_to_drop(), kNoPulses);
  EXPECT_TRUE(bench.processor.tick_compute.empty());
  bench.injector.end(Estop{.duration_s = 0.1}, Cycles{});
  EXPECT_EQ(bench.pins(), kPinsAtRest);
}

TEST(FaultInjector, HoldsTheEmergencyStopUntilTheLastOfSeveralEnds) {
  Bench bench;
  bench.injector.begin(Estop{.duration_s = 0.2}, kNow);
  bench.injector.begin(Estop{.duration_s = 0.1}, kNow);
  bench.injector.end(Estop{.duration_s = 0.1}, Cycles{});
  EXPECT_FALSE(bench.pins().estop_n);
  bench.injector.end(Estop{.duration_s = 0.2}, Cycles{});
  EXPECT_TRUE(bench.pins().estop_n);
}

TEST(FaultInjector, StopsTheClockUntilTheLastOfSeveralEnds) {
  class Counter final : public Soc {
   public:
    bool running = true;
    void set_clock_running(bool on) override { running = on; }
    void stop_clock_of(ClockGroup) override { ADD_FAILURE(); }

    [[nodiscard]] Cycles now() const override { return {}; }
    bool advance(Cycles, StopOn) override { return ADD_FAILURE(), false; }
    [[nodiscard]] bool idle() const override { return true; }
    std::optional<Cycles> start(const BusRequest&) override { return ADD_FAILURE(), std::nullopt; }
    [[nodiscard]] bool has_response() const override { return false; }
    std::optional<BusResponse> pop_response() override { return ADD_FAILURE(), std::nullopt; }
    [[nodiscard]] Cycles access_timeout() const override { return {}; }
    void set_inputs(const SocInputs&) override { ADD_FAILURE(); }
    [[nodiscard]] const SocOutputs& outputs() const override { return outputs_; }
    [[nodiscard]] std::uint8_t interrupts() const override { return 0; }
    void open_wave(const std::filesystem::path&, WaveFormat) override { ADD_FAILURE(); }
    void close_wave() override { ADD_FAILURE(); }

   private:
    SocOutputs outputs_;
  };
  Plant plant{RobotSpec{}};
  FaultyProcessor processor;
  Counter soc;
  FaultInjector injector{{.plant = plant, .processor = processor, .soc = soc}};
  EXPECT_TRUE(injector.clock_runs());
  injector.begin(ClockStop{.duration_s = 0.2}, kNow);
  injector.begin(ClockStop{.duration_s = 0.1}, kNow);
  EXPECT_FALSE(soc.running);
  EXPECT_FALSE(injector.clock_runs());
  injector.end(ClockStop{.duration_s = 0.1}, Cycles{});
  EXPECT_FALSE(soc.running);
  EXPECT_FALSE(injector.clock_runs());
  injector.end(ClockStop{.duration_s = 0.2}, Cycles{});
  EXPECT_TRUE(soc.running);
  EXPECT_TRUE(injector.clock_runs());
}

TEST(FaultInjector, WritesAWordAstray) {
  Bench bench;
  bench.injector.begin(StrayWrite{.address = 0x4280'0000, .data = 0xFFFF'FFFF}, kNow);
  EXPECT_EQ(bench.processor.stray_writes, (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0x4280'0000, ~0u}}));
  EXPECT_EQ(bench.pins(), kPinsAtRest);
}

TEST(FaultInjector, StopsTheClockOfTheNamedBlocksAndExplainsBusErrorsFromThenOn) {
  for (const ClockGroup group : {ClockGroup::kIo, ClockGroup::kMotion, ClockGroup::kEncoder}) {
    auto fabric = std::make_unique<FakeFabric>();
    const std::vector<std::string>& log = fabric->log;
    Plant plant{RobotSpec{}};
    FaultyProcessor processor;
    const std::unique_ptr<Soc> soc = test::pin_soc(std::move(fabric));
    FaultInjector injector{{.plant = plant, .processor = processor, .soc = *soc}};
    injector.begin(ClockStop{.duration_s = 0.1}, kNow);
    EXPECT_FALSE(injector.explains_bus_errors());
    injector.begin(BlockHang{.clock = group}, kNow);
    EXPECT_TRUE(injector.explains_bus_errors());
    EXPECT_EQ(log, (std::vector{"stop the clock of " + std::string{word_of(group)}}));
  }
}

TEST(FaultInjector, FlipsABitOfARegister) {
  Bench bench;
  bench.injector.begin(RegisterFlip{.address = 0x4280'0000, .bit = 31}, kNow);
  EXPECT_EQ(bench.processor.flips, (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0x4280'0000, 1u << 31}}));
  EXPECT_TRUE(bench.injector.leaves_cores_alone());
}

TEST(FaultInjector, FlipsABitOfTheMemoryOfTheCores) {
  Bench bench;
  bench.injector.begin(MemoryFlip{.symbol = "here", .offset = 8, .bit = 5}, kNow);
  EXPECT_EQ(bench.processor.memory_flips, (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0x108, 1u << 5}}));
  EXPECT_TRUE(bench.injector.explains_bus_errors());
  EXPECT_TRUE(bench.injector.leaves_cores_alone());
}

TEST(FaultInjector, SaysWhetherAFaultNeedsTheEdgesOfATick) {
  const auto leaves_ticks_alone = [](const FaultKind& kind) {
    Bench bench;
    bench.injector.begin(kind, kNow);
    return bench.injector.leaves_ticks_alone();
  };
  for (const FaultKind& kind : std::vector<FaultKind>{
           Estop{.duration_s = 1}, ClockStop{.duration_s = 1}, BlockHang{.clock = ClockGroup::kMotion},
           BlockHang{.clock = ClockGroup::kEncoder}, EncoderStuck{.axis = 1, .duration_s = 1}}) {
    EXPECT_FALSE(leaves_ticks_alone(kind)) << kind.index();
  }
  for (const FaultKind& kind :
       std::vector<FaultKind>{BlockHang{.clock = ClockGroup::kIo}, SlaveError{.address = 0x4280'0000, .count = 1},
                              UartBreak{.duration_s = 1}, InterruptLost{.duration_s = 1}}) {
    EXPECT_TRUE(leaves_ticks_alone(kind)) << kind.index();
  }
}

TEST(FaultInjector, StopsCoreOne) {
  Bench bench;
  bench.injector.begin(CoreOneStuck{}, kNow);
  EXPECT_EQ(bench.processor.core_one_stopped, kNow);
}

TEST(FaultInjector, HidesTheInterruptOfTheTimerAndNoOtherUntilItsEnd) {
  Bench bench;
  EXPECT_EQ(bench.injector.seen_interrupts(0xFF), 0xFF);
  bench.injector.begin(InterruptLost{.duration_s = 0.1}, kNow);
  EXPECT_EQ(bench.injector.seen_interrupts(0xFF), 0xFF & ~(1u << regs::soc::kAxiTimerIrq));
  EXPECT_FALSE(bench.injector.leaves_cores_alone());
  bench.injector.end(InterruptLost{.duration_s = 0.1}, Cycles{});
  EXPECT_EQ(bench.injector.seen_interrupts(0xFF), 0xFF);
  EXPECT_TRUE(bench.injector.leaves_cores_alone());
}

TEST(FaultInjector, HidesTheInterruptOfTheSerialLineAndNoOtherUntilItsEnd) {
  Bench bench;
  bench.injector.begin(UartOverrun{.duration_s = 0.1}, kNow);
  EXPECT_EQ(bench.injector.seen_interrupts(0xFF), 0xFF & ~(1u << regs::soc::kAxiUart16550Irq));
  EXPECT_FALSE(bench.injector.leaves_cores_alone());
  bench.injector.end(UartOverrun{.duration_s = 0.1}, Cycles{});
  EXPECT_EQ(bench.injector.seen_interrupts(0xFF), 0xFF);
  EXPECT_TRUE(bench.injector.leaves_cores_alone());
}

TEST(FaultInjector, AnswersSomeAccessesWithAnError) {
  Bench bench;
  bench.injector.begin(SlaveError{.address = 0x4280'0000, .count = 2}, kNow);
  EXPECT_TRUE(bench.injector.explains_bus_errors());
  EXPECT_FALSE(bench.injector.takes_for_error(0x4280'0004));
  EXPECT_TRUE(bench.injector.takes_for_error(0x4280'0000));
  EXPECT_FALSE(bench.injector.leaves_cores_alone());
  EXPECT_TRUE(bench.injector.takes_for_error(0x4280'0000));
  EXPECT_FALSE(bench.injector.takes_for_error(0x4280'0000));
  EXPECT_TRUE(bench.injector.leaves_cores_alone());
}

TEST(FaultInjector, DelaysResponsesByTheSumOfItsFaults) {
  Bench bench;
  bench.injector.begin(SlowSlave{.delay_us = 1, .duration_s = 1}, kNow);
  bench.injector.begin(SlowSlave{.delay_us = 0.02, .duration_s = 1}, kNow);
  EXPECT_EQ(bench.injector.response_delay(), Cycles{51});
  bench.injector.end(SlowSlave{.delay_us = 1, .duration_s = 1}, Cycles{});
  EXPECT_EQ(bench.injector.response_delay(), Cycles{1});
  bench.injector.end(SlowSlave{.delay_us = 0.02, .duration_s = 1}, Cycles{});
  EXPECT_TRUE(bench.injector.leaves_cores_alone());
}

TEST(FaultInjector, RaisesTheAlarmOfTheNamedDriveUntilItsEnd) {
  Bench bench;
  bench.injector.begin(DriveAlarm{.axis = 2, .duration_s = 1}, kNow);
  EXPECT_EQ(bench.pins().drive_alarm, 0b10);
  bench.injector.end(DriveAlarm{.axis = 2, .duration_s = 1}, Cycles{});
  EXPECT_EQ(bench.pins(), kPinsAtRest);  // its servo is off
}

TEST(FaultInjector, FaultsOfDifferentKindsActTogether) {
  Bench bench;
  bench.injector.begin(Estop{.duration_s = 0.1}, kNow);
  bench.injector.begin(PulseLoss{.axis = 1, .count = 2}, kNow);
  bench.injector.begin(SlowCore{.compute_us = 1}, kNow);
  EXPECT_FALSE(bench.pins().estop_n);
  EXPECT_EQ(bench.plant.pulses_to_drop(0), 2);
  EXPECT_EQ(bench.processor.tick_compute.size(), 1u);
}

}  // namespace
}  // namespace armature::cosim
