// The flops of the chip, as the verilated model has them.
#include "cosim/fabric/flops/flops.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <map>
#include <memory>
#include <regex>
#include <string>
#include <vector>

#include "cosim/fabric/verilated_fabric.hpp"
#include "cosim/flips/flip.hpp"
#include "cosim/model/model_fabric.hpp"

namespace armature::cosim {
namespace {

bool has(const std::vector<Flop>& flops, const Flop& flop) {
  return std::ranges::find(flops, flop) != flops.end();
}

TEST(Flops, HaveTheNamesOfTheDesign) {
  const std::vector<Flop> flops = make_verilated_fabric()->flops();
  EXPECT_TRUE(has(flops, {"u_axi_timer.u_core.enall_q", 1}));
  EXPECT_TRUE(has(flops, {"u_axi_uart16550.u_core.u_rx_fifo.entry_q[15]", 11}));
  EXPECT_TRUE(has(flops, {"g_rtl.u_pulse_train.u_core.gen_axis[5].u_gen.emitted_o", 32}));
  EXPECT_TRUE(has(flops, {"servo_on_o", 6}));
  EXPECT_TRUE(std::ranges::is_sorted(flops, std::ranges::less_equal{}, &Flop::name)) << "twice the same name";
  for (const Flop& flop : flops) {
    EXPECT_EQ(flop.name.find("__"), std::string::npos) << flop.name;
    EXPECT_FALSE(flop.name.ends_with("memory")) << flop.name;
  }
  EXPECT_TRUE(has(make_verilated_fabric(Variant::kPaper)->flops(), {"u_axi_timer.u_core.enall_q", 1}));
}

TEST(Flops, OfTheModelAreNone) {
  const std::unique_ptr<Fabric> fabric = model::make_model_fabric(Variant::kCounts);
  EXPECT_TRUE(fabric->flops().empty());
  EXPECT_FALSE(fabric->flip("u_axi_timer.u_core.enall_q", 0));
}

// The oracle is Yosys: its tables have the flip-flops of each block.
TEST(Flops, AreAtLeastThoseOfTheSynthesis) {
  std::map<std::string, int> bits;
  for (const Flop& flop : make_verilated_fabric()->flops()) bits[block_of(flop.name)] += flop.bits;
  // Verilator keeps the registers of the crossbar that drive a pin as this pin.
  bits["u_axi_lite_xbar"] = bits["u_xbar"] + bits["pins"];
  std::ifstream file{std::string{ARMATURE_SOURCE_DIR} + "/tools/synth/README.md"};
  const std::regex row{R"(\| (\w+) +\| +\d+ \| +(\d+) \|.*)"};
  int blocks = 0;
  for (std::string line; std::getline(file, line) && !line.starts_with("The variant of the paper");) {
    std::smatch match;
    if (!std::regex_match(line, match, row) || match[1] == "arm_soc") continue;
    ++blocks;
    EXPECT_GE(bits["u_" + match[1].str()], std::stoi(match[2])) << match[1];
  }
  EXPECT_EQ(blocks, 8);
}

TEST(Flops, AFlipOfEachBitChangesTheStateAndTwoDoNot) {
  const std::unique_ptr<Fabric> fabric = make_verilated_fabric();
  const std::uint64_t before = fabric->digest();
  for (const Flop& flop : fabric->flops()) {
    for (int bit = 0; bit < flop.bits; ++bit) {
      EXPECT_TRUE(fabric->flip(flop.name, bit));
      EXPECT_NE(fabric->digest(), before) << flop.name << ", bit " << bit;
      EXPECT_TRUE(fabric->flip(flop.name, bit));
      EXPECT_EQ(fabric->digest(), before) << flop.name << ", bit " << bit;
    }
  }
}

TEST(Flops, AFlipIsSeenAtThePinsAfterTheNextEdgeAndStays) {
  const std::unique_ptr<Fabric> fabric = make_verilated_fabric();
  SocInputs inputs;
  inputs.estop_n = true;
  fabric->set_inputs(inputs);
  while (fabric->run(1'000)) {
  }
  SocOutputs outputs = fabric->outputs();
  ASSERT_TRUE(fabric->flip("gpio_o", 3));
  EXPECT_EQ(fabric->outputs(), outputs);
  EXPECT_TRUE(fabric->run(1'000));
  outputs.gpio ^= 1u << 3;
  EXPECT_EQ(fabric->outputs(), outputs);
  EXPECT_FALSE(fabric->run(1'000));
}

TEST(Flops, OthersAreRefused) {
  const std::unique_ptr<Fabric> fabric = make_verilated_fabric();
  const std::uint64_t before = fabric->digest();
  EXPECT_FALSE(fabric->flip("u_axi_timer.u_core.enall", 0));
  EXPECT_FALSE(fabric->flip("u_axi_timer.u_core.enall_q", 1));
  EXPECT_FALSE(fabric->flip("u_axi_timer.u_core.enall_q", -1));
  EXPECT_EQ(fabric->digest(), before);
}

}  // namespace
}  // namespace armature::cosim
