// Every change at an input pin reaches the logic, in order, and at most one clock edge late.
#include "cosim/fabric/jittery_fabric.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "tests/support/fake_fabric.hpp"

namespace armature::cosim {
namespace {

// Remembers what each clock edge samples.
class Sampler final : public Fabric {
 public:
  explicit Sampler(std::vector<SocInputs>& samples) : samples_{samples} {}
  void set_inputs(const SocInputs& inputs) override { inputs_ = inputs; }
  void set_master(const AxiMasterPins&) override {}
  bool run(std::int64_t limit) override {
    for (std::int64_t i = 0; i < limit; ++i) samples_.push_back(inputs_);
    return false;
  }
  void stand_still(std::int64_t) override { ADD_FAILURE(); }
  void stop_clock_of(ClockGroup) override { ADD_FAILURE(); }
  [[nodiscard]] const SocOutputs& outputs() const override { return outputs_; }
  [[nodiscard]] AxiSlavePins slave() const override { return {}; }
  [[nodiscard]] Cycles cycle() const override { return Cycles{std::ssize(samples_)}; }
  void open_wave(const std::filesystem::path&, WaveFormat) override {}
  void close_wave() override {}

 private:
  std::vector<SocInputs>& samples_;
  SocInputs inputs_;
  SocOutputs outputs_;
};

// What 200 edges sample while enc_a counts in bits and the emergency stop toggles, a change every `hold` edges.
std::vector<SocInputs> samples(std::uint64_t seed, int hold) {
  std::vector<SocInputs> seen;
  const auto fabric = with_input_jitter(std::make_unique<Sampler>(seen), seed);
  for (int i = 0; i < 200 / hold; ++i) {
    SocInputs inputs;
    inputs.enc_a = static_cast<std::uint8_t>(i % 2 == 0 ? 0x3F : 0);
    inputs.estop_n = i % 3 != 0;
    fabric->set_inputs(inputs);
    fabric->run(hold);
  }
  return seen;
}

TEST(JitteryFabric, ShowsAChangeWithTheNextEdgeOrTheOneAfter) {
  for (const int hold : {2, 5}) {
    const std::vector<SocInputs> seen = samples(7, hold);
    int late = 0, mixed = 0;
    for (int i = 0; i < 200 / hold; ++i) {
      const auto first = static_cast<std::size_t>(i * hold);
      const std::uint8_t wanted = i % 2 == 0 ? 0x3F : 0;
      late += seen[first].enc_a != wanted;
      mixed += seen[first].enc_a != 0 && seen[first].enc_a != 0x3F;
      for (std::size_t edge = first + 1; edge < first + static_cast<std::size_t>(hold); ++edge) {
        ASSERT_EQ(seen[edge].enc_a, wanted);
        ASSERT_EQ(seen[edge].estop_n, i % 3 != 0);
      }
    }
    EXPECT_GT(late, 10);
    EXPECT_GT(mixed, 10) << "each bit by itself";
  }
}

TEST(JitteryFabric, TheSeedDecides) {
  EXPECT_EQ(samples(1, 2), samples(1, 2));
  EXPECT_NE(samples(1, 2), samples(2, 2));
}

TEST(JitteryFabric, WithoutAChangeItRunsToTheLimitAtOnce) {
  std::vector<SocInputs> seen;
  const auto fabric = with_input_jitter(std::make_unique<Sampler>(seen), 1);
  fabric->set_inputs({});
  EXPECT_FALSE(fabric->run(1000));
  EXPECT_EQ(fabric->cycle(), Cycles{1000});
}

}  // namespace
}  // namespace armature::cosim
