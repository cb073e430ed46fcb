// The whole logic and its model, clock for clock, under random legal traffic on the bus, random pins and random faults.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "controller/base/words.hpp"
#include "controller/regs/axi_timer_regs.hpp"
#include "controller/regs/axi_uart16550_regs.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "controller/regs/soc_map.hpp"
#include "cosim/engine/lockstep_fabric.hpp"
#include "cosim/fabric/jittery_fabric.hpp"
#include "cosim/fabric/verilated_fabric.hpp"
#include "cosim/model/model_fabric.hpp"
#include "tests/support/random_master.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::cosim {
namespace {

using test::BusTraffic;
using test::RandomMaster;
using test::SplitMix;

constexpr std::uint64_t kLockstepSeed = 20261127;

// What surrounds the logic: a master, six encoders that turn, switches, a serial line.
class Surroundings {
 public:
  Surroundings(Fabric& fabric, Variant variant, std::uint64_t seed) : fabric_{fabric}, random_{seed} {
    for (const auto& block : regs::soc::kBlocks) {
      if (block.variant.empty() || block.variant == word_of(variant)) bases_.push_back(block.base);
    }
  }

  void run(std::int64_t edges) {
    for (std::int64_t i = 0; i < edges; ++i) {
      if (i % 20'000 == 0) new_style();
      drive_bus();
      drive_pins();
      const AxiSlavePins before = fabric_.slave();
      fabric_.run(1);
      master_.edge(before);
    }
  }

  // The access that a controller makes before it moves: timer, counts, servo.
  void start_timer(std::uint32_t period) {
    namespace timer = regs::axi_timer;
    const std::uint32_t base = regs::soc::kAxiTimerBase;
    constexpr std::uint32_t kLoad = timer::kTcsr0LoadMask;
    constexpr std::uint32_t kRun = timer::kTcsr0UdtMask | timer::kTcsr0GentMask | timer::kTcsr0ArhtMask |
                                   timer::kTcsr0EnitMask | timer::kTcsr0EntMask;
    queue_ = {{base + timer::kTcsr0Offset, kRun},
              {base + timer::kTcsr0Offset, kLoad},
              {base + timer::kTlr0Offset, period - 2}};
  }

 private:
  void new_style() {
    gap_ = 1 + random_.below(60);
    lazy_ = 1 + random_.below(3);
    for (auto& axis : axes_) axis.period = random_.below(3) == 0 ? 0 : 12 + random_.below(200);
    bit_ = 16 * (1 + random_.below(4));
    if (random_.below(2) == 0) start_timer(200 + random_.below(2400));
  }

  void drive_bus() {
    if (!master_.writes() && !queue_.empty()) {
      master_.write(queue_.back());
      queue_.pop_back();
    }
    if (!master_.writes() && random_.below(gap_) == 0) master_.write(any_write());
    if (!master_.reads() && random_.below(gap_) == 0) master_.read(any_address());
    master_.drive(lazy_);
    fabric_.set_master(master_.pins());
  }

  std::uint32_t any_address() {
    const std::uint32_t base = bases_[random_.below(static_cast<std::uint32_t>(bases_.size()))];
    if (random_.below(200) == 0) return static_cast<std::uint32_t>(random_.next());
    if (base == regs::soc::kAxiUart16550Base) return base + 0x1000 + 4 * random_.below(9);
    if (base == regs::soc::kIkCordicBase && random_.below(2) == 0) return base + 4 * random_.below(8);
    if (base == regs::soc::kPolicyMlpBase) return base + 4 * random_.below(26);
    if (base == regs::soc::kAxiGpioBase && random_.below(2) == 0) return base + 0x11C + 4 * random_.below(4);
    return base + 4 * random_.below(base == regs::soc::kAxiTimerBase ? 8 : 0x38);
  }

  BusTraffic any_write() {
    const std::uint32_t address = any_address();
    std::uint32_t data = static_cast<std::uint32_t>(random_.next()) >> random_.below(32);
    if (address == regs::soc::kAxiUart16550Base + regs::axi_uart16550::kRbrOffset && random_.below(2) == 0) data &= 3;
    if ((address >> 16) == (regs::soc::kPulseTrainBase >> 16) && random_.below(2) == 0) data = random_.below(13);
    return {address, data, random_.below(4) == 0 ? static_cast<std::uint8_t>(random_.below(16)) : std::uint8_t{0xF}};
  }

  void drive_pins() {
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      Axis& axis = axes_[i];
      if (axis.period == 0 || ++axis.age < axis.period) continue;
      axis.age = 0;
      if (random_.below(50) == 0) axis.up = !axis.up;
      axis.count += axis.up ? 1 : 3;
      const auto set = [i](std::uint8_t& pins, bool level) {
        pins = static_cast<std::uint8_t>((pins & ~(1u << i)) | (level ? 1u << i : 0u));
      };
      set(pins_.enc_a, ((axis.count + 1) & 2) != 0);
      set(pins_.enc_b, (axis.count & 2) != 0);
      set(pins_.enc_z, axis.count % 40 == 0);
    }
    if (cycle_ % bit_ == 0) pins_.uart_rxd = random_.below(2) != 0;
    if (random_.below(300) == 0) change_a_pin();
    ++cycle_;
    fabric_.set_inputs(pins_);
  }

  void change_a_pin() {
    const auto flip = [&](std::uint8_t& pins) { pins ^= static_cast<std::uint8_t>(1u << random_.below(6)); };
    switch (random_.below(14)) {
      case 0:
        return flip(pins_.home);
      case 1:
        return flip(pins_.limit_neg);
      case 2:
        return flip(pins_.limit_pos);
      case 3:
        return flip(pins_.drive_alarm);
      case 4:
        return flip(pins_.in_position);
      case 5:
        pins_.gpio ^= static_cast<std::uint16_t>(1u << random_.below(16));
        return;
      case 6:
        pins_.gpio1 ^= static_cast<std::uint16_t>(1u << random_.below(16));
        return;
      case 7:
        pins_.uart_cts_n = !pins_.uart_cts_n;
        return;
      case 8:
        pins_.uart_ri_n = !pins_.uart_ri_n;
        return;
      case 9:
        pins_.capture_trig = !pins_.capture_trig;
        return;
      case 10:
        return flip(pins_.enc_a);  // a glitch: the next step of the encoder sets it right
      case 11:
        return flip(pins_.enc_z);
      default:
        pins_.estop_n = !pins_.estop_n || random_.below(20) != 0;
    }
  }

  struct Axis {
    std::uint32_t period = 0, age = 0, count = 0;
    bool up = true;
  };

  Fabric& fabric_;
  SplitMix random_;
  RandomMaster master_{random_};
  std::vector<std::uint32_t> bases_;
  std::vector<BusTraffic> queue_;  // the last one first
  std::array<Axis, 6> axes_{};
  SocInputs pins_;
  std::uint32_t gap_ = 10, lazy_ = 1, bit_ = 16;
  std::uint32_t cycle_ = 0;
};

class SocLockstep : public ::testing::TestWithParam<Variant> {
 protected:
  static std::unique_ptr<Fabric> pair() {
    return in_lockstep(make_verilated_fabric(GetParam()), model::make_model_fabric(GetParam()));
  }
  // Runs to the first difference, which fails the test.
  static void run(Fabric& fabric, Surroundings& surroundings, std::int64_t edges) {
    try {
      surroundings.run(edges);
    } catch (const EnginesDiffer& difference) {
      FAIL() << "seed " << kLockstepSeed << ", cycle " << difference.cycle.value() << ": " << difference.what;
    }
    EXPECT_EQ(fabric.cycle().value(), edges);
  }
};
INSTANTIATE_TEST_SUITE_P(Variants, SocLockstep, ::testing::Values(Variant::kCounts, Variant::kPaper),
                         [](const auto& suite) { return std::string{word_of(suite.param)}; });

TEST_P(SocLockstep, RandomTrafficAndRandomPins) {
  const auto fabric = pair();
  Surroundings surroundings{*fabric, GetParam(), kLockstepSeed};
  run(*fabric, surroundings, 300'000);
}

TEST_P(SocLockstep, RandomTrafficWithJitterOfThePins) {
  const auto fabric = with_input_jitter(pair(), kLockstepSeed);
  Surroundings surroundings{*fabric, GetParam(), kLockstepSeed + 1};
  run(*fabric, surroundings, 100'000);
}

TEST_P(SocLockstep, BlocksThatHang) {
  for (const ClockGroup group : {ClockGroup::kIo, ClockGroup::kMotion, ClockGroup::kEncoder}) {
    const auto fabric = pair();
    Surroundings surroundings{*fabric, GetParam(), kLockstepSeed + 2};
    ASSERT_NO_FATAL_FAILURE(run(*fabric, surroundings, 20'000));
    fabric->stop_clock_of(group);
    try {
      surroundings.run(40'000);
    } catch (const EnginesDiffer& difference) {
      FAIL() << word_of(group) << ", cycle " << difference.cycle.value() << ": " << difference.what;
    }
  }
}

// At each of many clocks in a row, so that some of them are within a response.
TEST_P(SocLockstep, BlocksThatHangAtAnyClockOfAnAccess) {
  for (const ClockGroup group : {ClockGroup::kIo, ClockGroup::kMotion, ClockGroup::kEncoder}) {
    for (std::int64_t clock = 0; clock < 40; ++clock) {
      const auto fabric = pair();
      Surroundings surroundings{*fabric, GetParam(), kLockstepSeed + 3};
      ASSERT_NO_FATAL_FAILURE(run(*fabric, surroundings, 100 + clock));
      fabric->stop_clock_of(group);
      try {
        surroundings.run(400);
      } catch (const EnginesDiffer& difference) {
        FAIL() << word_of(group) << ", clock " << clock << ", cycle " << difference.cycle.value() << ": "
               << difference.what;
      }
    }
  }
}

}  // namespace
}  // namespace armature::cosim
