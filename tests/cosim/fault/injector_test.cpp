// Each kind of fault acts where it should and nowhere else, until its end.
#include "cosim/fault/injector.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace armature::cosim {
namespace {

// Records what a fault does to it; faults must not call the rest.
class FaultyProcessor final : public Processor {
 public:
  std::vector<Cycles> tick_compute;

  void set_tick_compute(Cycles cost) override { tick_compute.push_back(cost); }

  mailbox::Memory& mailbox() override {
    ADD_FAILURE();
    return memory_;
  }
  void notify(Cycles) override { ADD_FAILURE(); }
  std::optional<Cycles> next_event() const override { return std::nullopt; }
  void advance(Cycles) override { ADD_FAILURE(); }
  std::optional<Access> next_access() const override { return std::nullopt; }
  void complete(int, const BusResponse&, Cycles) override { ADD_FAILURE(); }
  void set_interrupts(std::uint8_t, Cycles) override { ADD_FAILURE(); }
  Cycles worst_tick(Cycles) const override { return {}; }
  void reset_worst_tick() override { ADD_FAILURE(); }

 private:
  mailbox::Memory memory_;
};

struct Bench {
  Plant plant{RobotSpec{}};
  FaultyProcessor processor;
  FaultInjector injector{{.plant = plant, .processor = processor}};

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
  bench.injector.begin(PulseLoss{.axis = 3, .count = 500});
  EXPECT_EQ(bench.pulses_to_drop(), (PerAxis<std::int64_t>{0, 0, 500, 0, 0, 0}));
  EXPECT_TRUE(bench.processor.tick_compute.empty());
  EXPECT_EQ(bench.pins(), kPinsAtRest);
}

TEST(FaultInjector, ChangesTheTimeThatCoreZeroComputes) {
  Bench bench;
  bench.injector.begin(SlowCore{.compute_us = 60});
  EXPECT_EQ(bench.processor.tick_compute, (std::vector{Cycles{3000}}));
  EXPECT_EQ(bench.pulses_to_drop(), kNoPulses);
  EXPECT_EQ(bench.pins(), kPinsAtRest);
}

TEST(FaultInjector, HoldsTheEmergencyStopAndNoOtherPinUntilItsEnd) {
  Bench bench;
  bench.injector.begin(Estop{.duration_s = 0.1});
  SocInputs stopped = kPinsAtRest;
  stopped.estop_n = false;
  EXPECT_EQ(bench.pins(), stopped);
  EXPECT_EQ(bench.pulses_to_drop(), kNoPulses);
  EXPECT_TRUE(bench.processor.tick_compute.empty());
  bench.injector.end(Estop{.duration_s = 0.1});
  EXPECT_EQ(bench.pins(), kPinsAtRest);
}

TEST(FaultInjector, HoldsTheEmergencyStopUntilTheLastOfSeveralEnds) {
  Bench bench;
  bench.injector.begin(Estop{.duration_s = 0.2});
  bench.injector.begin(Estop{.duration_s = 0.1});
  bench.injector.end(Estop{.duration_s = 0.1});
  EXPECT_FALSE(bench.pins().estop_n);
  bench.injector.end(Estop{.duration_s = 0.2});
  EXPECT_TRUE(bench.pins().estop_n);
}

TEST(FaultInjector, FaultsOfDifferentKindsActTogether) {
  Bench bench;
  bench.injector.begin(Estop{.duration_s = 0.1});
  bench.injector.begin(PulseLoss{.axis = 1, .count = 2});
  bench.injector.begin(SlowCore{.compute_us = 1});
  EXPECT_FALSE(bench.pins().estop_n);
  EXPECT_EQ(bench.plant.pulses_to_drop(0), 2);
  EXPECT_EQ(bench.processor.tick_compute.size(), 1u);
}

}  // namespace
}  // namespace armature::cosim
