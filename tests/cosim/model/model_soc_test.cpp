// ModelSoc against the same model behind the bus clock for clock: the cycle and the content of every response, every
// pin.
#include "cosim/model/model_soc.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "controller/base/words.hpp"
#include "controller/regs/soc_map.hpp"
#include "cosim/model/model_fabric.hpp"
#include "cosim/soc/pin_soc.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::cosim {
namespace {

using test::SplitMix;

constexpr std::uint64_t kSeed = 7;

struct Case {
  Variant variant = Variant::kCounts;
  std::int64_t latency = 6;
  double stalls = 0.0;
  bool faults = false;  // clocks that stop, blocks that hang
};

BusRequest random_request(SplitMix& random) {
  const auto& block = regs::soc::kBlocks[random.below(std::size(regs::soc::kBlocks))];
  const std::uint32_t start = block.name == "axi_uart16550" ? 0x1000 : 0;
  const std::uint32_t address =
      random.below(30) == 0 ? static_cast<std::uint32_t>(random.next()) : block.base + start + 4 * random.below(0x38);
  return {.write = random.below(2) == 0,
          .addr = address,
          .data = static_cast<std::uint32_t>(random.next()) >> random.below(32),
          .strobes = random.below(4) == 0 ? static_cast<std::uint8_t>(random.below(16)) : std::uint8_t{0xF}};
}

// Both do the same; compares after each step of time.
class Twins {
 public:
  explicit Twins(const Case& what)
      : bus_{.latency_cycles = what.latency, .stall_probability = what.stalls},
        quick_{model::make_model_soc(what.variant, bus_, kSeed)},
        reference_{std::make_unique<PinSoc>(model::make_model_fabric(what.variant), bus_, kSeed)},
        faults_{what.faults} {}

  void run(Cycles end) {
    while (quick_->now() < end) {
      act();
      const Cycles limit = quick_->now() + Cycles{1 + random_.below(random_.below(4) == 0 ? 2000 : 12)};
      const auto stop = static_cast<StopOn>(random_.below(3));
      const bool stopped = quick_->advance(limit, stop);
      EXPECT_EQ(reference_->advance(limit, stop), stopped);
      ASSERT_EQ(quick_->now(), reference_->now());
      ASSERT_EQ(quick_->outputs(), reference_->outputs()) << "cycle " << quick_->now().value();
      ASSERT_EQ(quick_->interrupts(), reference_->interrupts());
      ASSERT_NO_FATAL_FAILURE(take_response());
    }
  }

  [[nodiscard]] int responses(BusError error) const { return responses_[static_cast<std::size_t>(error)]; }

 private:
  void act() {
    ASSERT_EQ(quick_->idle(), reference_->idle());
    if (quick_->idle() && random_.below(3) == 0) {
      const BusRequest request = random_request(random_);
      quick_->start(request);
      reference_->start(request);
    }
    if (random_.below(100) == 0) {
      inputs_.enc_a ^= static_cast<std::uint8_t>(random_.below(64));
      inputs_.gpio ^= static_cast<std::uint16_t>(random_.below(256));
      inputs_.estop_n = random_.below(4) != 0;
      quick_->set_inputs(inputs_);
      reference_->set_inputs(inputs_);
    }
    if (!faults_) return;
    if (random_.below(50) == 0) {
      const bool runs = random_.below(3) != 0;
      quick_->set_clock_running(runs);
      reference_->set_clock_running(runs);
    }
    if (random_.below(20'000) == 0) {
      const auto group = static_cast<ClockGroup>(random_.below(3));
      quick_->stop_clock_of(group);
      reference_->stop_clock_of(group);
    }
  }

  void take_response() {
    const std::optional<BusResponse> quick = quick_->pop_response();
    const std::optional<BusResponse> reference = reference_->pop_response();
    ASSERT_EQ(quick.has_value(), reference.has_value()) << "cycle " << quick_->now().value();
    if (!quick) return;
    ASSERT_EQ(quick->error, reference->error) << "cycle " << quick_->now().value();
    if (quick->error == BusError::kNone) {
      ASSERT_EQ(quick->data, reference->data) << "cycle " << quick_->now().value();
    }
    ++responses_[static_cast<std::size_t>(quick->error)];
  }

  BusSpec bus_;
  std::unique_ptr<Soc> quick_, reference_;
  bool faults_;
  SplitMix random_{kSeed};
  SocInputs inputs_;
  std::array<int, kBusErrorNames.size()> responses_{};
};

class ModelSoc : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Cases, ModelSoc,
                         ::testing::Values(Case{}, Case{.latency = 0}, Case{.latency = 1}, Case{.latency = 40},
                                           Case{.variant = Variant::kPaper}, Case{.stalls = 0.3}, Case{.faults = true},
                                           Case{.variant = Variant::kPaper, .latency = 3, .faults = true}));

TEST_P(ModelSoc, EveryResponseComesInTheCycleOfTheHandshakes) {
  Twins twins{GetParam()};
  ASSERT_NO_FATAL_FAILURE(twins.run(Cycles{1'000'000}));
  EXPECT_GT(twins.responses(BusError::kNone), 100);
  EXPECT_GT(twins.responses(BusError::kSlaveError), 50);
  EXPECT_GT(twins.responses(BusError::kDecodeError), 5);
}

}  // namespace
}  // namespace armature::cosim
