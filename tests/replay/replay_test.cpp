// Reset completeness: arm_soc with random bits in every flop, also in those that a long random life left behind, does
// after a reset exactly what was recorded in the simulator, whose model starts with zeros.
#include <gtest/gtest.h>
#include <verilated.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "Varm_soc.h"
#include "Varm_soc_paper_test.h"
#include "tests/replay/vectors.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::test {
namespace {

constexpr int kSeeds[] = {1, 20210417, 1729};
constexpr int kLifeBeforeReset = 3000;  // clocks

// VECTORS of the environment: the folder of the recorded files.
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

  // Any input, any level: whatever state that leads to, the next reset must end it.
  void live(std::uint64_t seed, int clocks) {
    SplitMix random{seed};
    for (int i = 0; i < clocks; ++i) {
      Vector vector;
      for (std::uint32_t& word : vector) word = static_cast<std::uint32_t>(random.next());
      // Mostly addresses of registers.
      vector[0] = 0x43C0'0000u | (vector[0] & 0x3'11FFu);
      vector[2] = 0x43C0'0000u | (vector[2] & 0x3'11FFu);
      drive(vector);
      edge();
    }
  }

  void reset() {
    Vector idle{};
    idle[5] = 3u << 18;  // estop_ni and uart_rxd_i
    drive(idle);
    dut_->rst_ni = 0;
    for (int i = 0; i < kReplayResetCycles; ++i) edge();
    dut_->rst_ni = 1;
  }

  // The first clock whose outputs differ from the recorded ones, -1 if there is none.
  std::int64_t replay(const std::vector<Vector>& vectors) {
    for (std::size_t clock = 0; clock < vectors.size(); ++clock) {
      drive(vectors[clock]);
      edge();
      if (!matches(vectors[clock])) return static_cast<std::int64_t>(clock);
    }
    return -1;
  }

 private:
  template <class Pin>
  static void set(Pin& pin, std::uint32_t word, int position, std::uint32_t mask) {
    pin = static_cast<Pin>(word >> position & mask);
  }

  void drive(const Vector& v) {
    dut_->s_axi_awaddr_i = v[0];
    dut_->s_axi_wdata_i = v[1];
    dut_->s_axi_araddr_i = v[2];
    set(dut_->s_axi_awvalid_i, v[3], 0, 1);
    set(dut_->s_axi_wvalid_i, v[3], 1, 1);
    set(dut_->s_axi_bready_i, v[3], 2, 1);
    set(dut_->s_axi_arvalid_i, v[3], 3, 1);
    set(dut_->s_axi_rready_i, v[3], 4, 1);
    set(dut_->s_axi_wstrb_i, v[3], 8, 0xF);
    set(dut_->enc_a_i, v[4], 0, 0x3F);
    set(dut_->enc_b_i, v[4], 6, 0x3F);
    set(dut_->enc_z_i, v[4], 12, 0x3F);
    set(dut_->home_i, v[4], 18, 0x3F);
    set(dut_->limit_pos_i, v[4], 24, 0x3F);
    set(dut_->limit_neg_i, v[5], 0, 0x3F);
    set(dut_->drive_alarm_i, v[5], 6, 0x3F);
    set(dut_->in_position_i, v[5], 12, 0x3F);
    set(dut_->estop_ni, v[5], 18, 1);
    set(dut_->uart_rxd_i, v[5], 19, 1);
    set(dut_->capture_trig_i, v[5], 20, 1);
    set(dut_->gpio_i, v[6], 0, 0xFFFF);
  }

  bool matches(const Vector& v) const {
    const auto at = [](std::uint32_t level, int position) { return level << position; };
    return dut_->s_axi_rdata_o == v[7] &&
           v[8] == (at(dut_->s_axi_awready_o, 0) | at(dut_->s_axi_wready_o, 1) | at(dut_->s_axi_bvalid_o, 2) |
                    at(dut_->s_axi_arready_o, 3) | at(dut_->s_axi_rvalid_o, 4) | at(dut_->s_axi_bresp_o, 8) |
                    at(dut_->s_axi_rresp_o, 10) | at(dut_->gpio_o, 16)) &&
           v[9] == (at(dut_->step_o, 0) | at(dut_->dir_o, 6) | at(dut_->servo_on_o, 12) | at(dut_->trigger_o, 18) |
                    at(dut_->uart_txd_o, 19) | at(dut_->pwm_o, 20) | at(dut_->irq_o, 24));
  }

  // Every edge on both clocks, whatever the recorded run left out.
  void edge() {
    dut_->clk_i = dut_->clk_io_i = 1;
    dut_->eval();
    dut_->clk_i = dut_->clk_io_i = 0;
    dut_->eval();
  }

  VerilatedContext context_;
  std::unique_ptr<Dut> dut_;
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
  used.live(kSeeds[0], kLifeBeforeReset);
  used.reset();
  EXPECT_EQ(used.replay(vectors), -1) << name << ", after a random life";
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
