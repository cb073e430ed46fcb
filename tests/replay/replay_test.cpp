// Reset completeness. arm_soc starts with random bits in every flop, or with the state after long random traffic.
// After a reset its outputs must equal the recording of the simulator, whose model starts with zeros.
#include <gtest/gtest.h>
#include <verilated.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "Varm_soc.h"
#include "Varm_soc_paper_test.h"
#include "cosim/fabric/gated_clocks.hpp"
#include "cosim/fabric/model_bus.hpp"
#include "cosim/fabric/model_pins.hpp"
#include "tests/replay/vectors.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::test {
namespace {

constexpr int kSeeds[] = {1, 20210417, 1729};
constexpr int kTrafficBeforeReset = 3000;  // clocks

// The environment variable VECTORS is the folder of the recorded files.
std::vector<Vector> recorded(const std::string& name) {
  const char* folder = std::getenv("VECTORS");
  VectorFile file{std::filesystem::path{folder == nullptr ? "." : folder} / name, "r"};
  std::vector<Vector> vectors;
  while (const auto vector = file.read()) vectors.push_back(*vector);
  return vectors;
}

template <class Dut>
class Replayer {
 public:
  explicit Replayer(int seed) {
    context_.randReset(2);
    context_.randSeed(seed);
    dut_ = std::make_unique<Dut>(&context_);
  }
  ~Replayer() { dut_->final(); }

  // Random levels on all inputs. The next reset must clear the resulting state.
  void drive_random_traffic(std::uint64_t seed, int clocks) {
    SplitMix random{seed};
    for (int i = 0; i < clocks; ++i) {
      Vector vector;
      for (std::uint32_t& word : vector) word = static_cast<std::uint32_t>(random.next());
      unpack(vector, inputs_, master_);
      // Mostly addresses of registers.
      master_.awaddr = 0x43C0'0000u | (master_.awaddr & 0x3'11FFu);
      master_.araddr = 0x43C0'0000u | (master_.araddr & 0x3'11FFu);
      drive();
      edge();
    }
  }

  void reset() {
    inputs_ = {};
    master_ = {};
    drive();
    dut_->rst_ni = 0;
    for (int i = 0; i < kReplayResetCycles; ++i) edge();
    dut_->rst_ni = 1;
  }

  // Returns the first clock whose outputs differ from the recording, -1 if there is none.
  std::int64_t replay(const std::vector<Vector>& vectors) {
    for (std::size_t clock = 0; clock < vectors.size(); ++clock) {
      unpack(vectors[clock], inputs_, master_);
      drive();
      edge();
      if (pack(inputs_, master_, cosim::sample_pins(*dut_), cosim::sample_bus(*dut_)) != vectors[clock])
        return static_cast<std::int64_t>(clock);
    }
    return -1;
  }

 private:
  void drive() {
    cosim::drive_pins(*dut_, inputs_);
    cosim::drive_bus(*dut_, master_);
  }

  // Every edge on every clock: no clock gating, also if the recorded run had it.
  void edge() { cosim::eval_edge(*dut_, cosim::needed_clocks(*dut_, cosim::kAllGatedClocks)); }

  VerilatedContext context_;
  std::unique_ptr<Dut> dut_;
  cosim::SocInputs inputs_;
  cosim::AxiMasterPins master_;
};

template <class Dut>
void expect_same_after_any_power_up(const std::string& name) {
  const std::vector<Vector> vectors = recorded(name);
  ASSERT_FALSE(vectors.empty());
  for (const int seed : kSeeds) {
    Replayer<Dut> replayer{seed};
    replayer.reset();
    EXPECT_EQ(replayer.replay(vectors), -1) << name << ", power-up seed " << seed;
  }
  Replayer<Dut> used{kSeeds[0]};
  used.reset();
  used.drive_random_traffic(kSeeds[0], kTrafficBeforeReset);
  used.reset();
  EXPECT_EQ(used.replay(vectors), -1) << name << ", after random traffic";
}

TEST(Replay, AMoveIsTheSameAfterAnyPowerUp) {
  expect_same_after_any_power_up<Varm_soc>("counts_move.txt");
}
TEST(Replay, RandomTrafficIsTheSameAfterAnyPowerUp) {
  expect_same_after_any_power_up<Varm_soc>("counts_random.txt");
}
TEST(Replay, ThePaperFabricIsTheSameAfterAnyPowerUp) {
  expect_same_after_any_power_up<Varm_soc_paper_test>("paper_random.txt");
}

}  // namespace
}  // namespace armature::test
