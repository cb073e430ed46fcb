// policy_core bit for bit against plain arithmetic and against its model: random networks, edges, broken images.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "Vpolicy_core.h"
#include "tests/controller/support/draws.hpp"
#include "tests/rtl/policy_core_fixture.hpp"

namespace armature::test {
namespace {

class PolicyCore : public PolicyCoreFixture<Vpolicy_core, 8> {
 protected:
  // One neuron with one input of 1 and this weight; everything else is 0.
  void set_neuron(std::int32_t bias, std::uint32_t multiplier, std::uint32_t shift, bool relu = false) {
    load(image_of({{.relu = relu, .neurons = {{bias, multiplier, shift, {0}}}}}, 8));
    dut_.crc_value_i = mlp::evaluate(memory_, 8, inputs_).crc;
  }
  int value_of(std::int32_t bias, std::uint32_t multiplier, std::uint32_t shift, bool relu = false) {
    set_neuron(bias, multiplier, shift, relu);
    run();
    EXPECT_TRUE(dut_.status_done_o);
    return outputs()[0];
  }
};

TEST_F(PolicyCore, HasTheBitsOfPlainArithmeticForRandomNetworks) {
  RandomNetworks networks{3701};
  for (int i = 0; i < draws(200); ++i) {
    SCOPED_TRACE(i);
    const TestNetwork network = networks.next();
    expect_plain_arithmetic(network, networks.inputs(network[0].neurons[0].weights.size()));
  }
}

TEST_F(PolicyCore, EvaluatesTheLargestNetworkInTheStatedTime) {
  RandomNetworks networks{3702};
  expect_plain_arithmetic(networks.of({32, 64, 64, 64, 8}), networks.inputs(32));
  EXPECT_EQ(dut_.cycles_value_o, 1569);
  expect_plain_arithmetic(networks.of({16, 64, 64, 6}), networks.inputs(16));
  EXPECT_EQ(dut_.cycles_value_o, 841);
}

// Whatever the memory contains, the end comes, with the bits and the time of the model.
TEST_F(PolicyCore, EndsWithTheBitsOfTheModelForRandomMemories) {
  RandomNetworks networks{3703};
  SplitMix& random = networks.random();
  int malformed = 0;
  for (int i = 0; i < draws(60); ++i) {
    SCOPED_TRACE(i);
    TestImage image(4096);
    for (std::uint32_t& word : image) word = static_cast<std::uint32_t>(random.next());
    load(image);
    set(networks.inputs(32));
    malformed += expect_the_model().malformed;
  }
  RecordProperty("malformed", malformed);
  EXPECT_GT(malformed, 0);
}

// 4 + 64 * 9 + 64 * 9 + 60 * 9 + 44 * 8 rows fill the memory.
TEST_F(PolicyCore, RunsToTheLastRowOfTheMemoryAndNotBeyond) {
  const auto layer = [](std::size_t neurons, std::size_t rows) {
    return TestLayer{.neurons = std::vector<TestNeuron>(neurons, {20, 0x8000, 0, std::vector<std::int8_t>(8 * rows)})};
  };
  for (const std::size_t neurons : {43u, 44u, 45u}) {
    TestImage image = image_of({layer(64, 8), layer(64, 8), layer(60, 8), layer(neurons, 7)}, 8);
    ASSERT_EQ(image.size(), 4096 - 16 * (44 - neurons));
    image.resize(4096);
    load(image);
    const mlp::Outcome outcome = expect_the_model();
    EXPECT_EQ(outcome.malformed, neurons == 45);
    EXPECT_EQ(outcome.clocks, 1 + (neurons == 43 ? 2040 : 2048) + 4 * 5);
    EXPECT_EQ(outputs()[0], neurons == 45 ? 0 : 10);
  }
}

TEST_F(PolicyCore, AFifthLayerIsMalformed) {
  RandomNetworks networks{3704};
  for (const std::size_t layers : {4u, 5u}) {
    std::vector<std::size_t> sizes(layers + 1, 3);
    load(image_of(networks.of(sizes), 8));
    set(networks.inputs(3));
    EXPECT_EQ(expect_the_model().malformed, layers == 5);
  }
}

TEST_F(PolicyCore, RoundsHalvesUpwards) {
  // bias * 2^15 / 2^16: halves.
  EXPECT_EQ(value_of(1, 0x8000, 0), 1);
  EXPECT_EQ(value_of(-1, 0x8000, 0), 0);
  EXPECT_EQ(value_of(-3, 0x8000, 0), -1);
  EXPECT_EQ(value_of(3, 0x8000, 0), 2);
  EXPECT_EQ(value_of(1, 0x7FFF, 0), 0);
  EXPECT_EQ(value_of(-2, 0x8001, 0), -1);
  EXPECT_EQ(value_of(5, 0x8000, 1), 1);
  EXPECT_EQ(value_of(6, 0x8000, 1), 2);
}

TEST_F(PolicyCore, LimitsValuesToEightBits) {
  EXPECT_EQ(value_of(127 * 2, 0x8000, 0), 127);
  EXPECT_EQ(value_of(128 * 2, 0x8000, 0), 127);
  EXPECT_EQ(value_of(0x7F'FFFF, 0xFFFF, 0), 127);
  EXPECT_EQ(value_of(-127 * 2, 0x8000, 0), -127);
  EXPECT_EQ(value_of(-200 * 2, 0x8000, 0), -127);
  EXPECT_EQ(value_of(-0x80'0000, 0xFFFF, 0), -127) << "-128, limited by the bound";
  EXPECT_EQ(value_of(-5, 0xFFFF, 0, true), 0);
  EXPECT_EQ(value_of(5, 0xFFFF, 0, true), 5);
  EXPECT_EQ(value_of(0x7F'FFFF, 0xFFFF, 31), 0);
  EXPECT_EQ(value_of(-0x80'0000, 0xFFFF, 31), 0);
  EXPECT_EQ(value_of(0x7F'FFFF, 0xFFFF, 16), 127);
  EXPECT_EQ(value_of(0x7F'FFFF, 0xFFFF, 17), 64);
}

// The largest sums in both directions. 25 bits hold them: an assertion of the block compares each sum.
TEST_F(PolicyCore, NoSumOverflows) {
  for (const std::int8_t value : {std::int8_t{-128}, std::int8_t{127}}) {
    const std::int32_t bias = value < 0 ? 0x7F'FFFF : -0x80'0000;
    TestNetwork network(2);
    const std::int8_t hidden = 127;
    network[0] = {.neurons = std::vector<TestNeuron>(64, {hidden * 2 * (value < 0 ? -1 : 1), 0x8000, 0, {0}})};
    network[1] = {.neurons = {{bias, 0xFFFF, 10, std::vector<std::int8_t>(64, -128)}}};
    expect_plain_arithmetic(network, {1});
  }
}

// The number is that of zlib.crc32 in Python.
TEST_F(PolicyCore, ReadsTheChecksumOfItsRows) {
  load({0x0002'0000, 0, 0x0500'0007, 0x8000, 0x0403'0201, 0x0807'0605});
  run();
  EXPECT_EQ(dut_.crc_read_value_o, 0x404E'2AF5u);
  EXPECT_TRUE(dut_.status_corrupt_o);
  EXPECT_FALSE(dut_.status_done_o);
  EXPECT_EQ(dut_.output_values_o, 0U);
  dut_.crc_value_i = 0x404E'2AF5;
  run();
  EXPECT_FALSE(dut_.status_corrupt_o);
  EXPECT_TRUE(dut_.status_done_o);
}

TEST_F(PolicyCore, AFlippedBitOfTheImageGivesNoOutput) {
  RandomNetworks networks{3705};
  const TestImage image = image_of(networks.of({16, 8, 6}), 8);
  load(image);
  set(networks.inputs(16));
  EXPECT_FALSE(expect_the_model().malformed);
  for (int i = 0; i < draws(200); ++i) {
    const std::uint32_t word = networks.random().below(static_cast<std::uint32_t>(image.size()));
    const std::uint32_t flipped = image[word] ^ (1u << networks.random().below(32));
    set_address(word);
    put(flipped);
    run();
    EXPECT_TRUE(dut_.status_corrupt_o) << word;
    EXPECT_FALSE(dut_.status_done_o);
    EXPECT_EQ(dut_.output_values_o, 0U);
    set_address(word);
    put(image[word]);
  }
  run();
  EXPECT_TRUE(dut_.status_done_o);
}

TEST_F(PolicyCore, NoOutputIsBeyondTheBoundFromItsWriteOn) {
  RandomNetworks networks{3706};
  int limited = 0;
  for (int i = 0; i < 5; ++i) {
    load(image_of(networks.of({8, 8}), 8));
    set(networks.inputs(8));
    dut_.bound_value_i = 127;
    const mlp::Outcome expected = expect_the_model();
    for (int bound = 0; bound < 128; ++bound) {
      dut_.bound_value_i = static_cast<std::uint8_t>(bound);
      dut_.eval();
      const std::vector<std::int8_t> seen = outputs();
      for (std::size_t k = 0; k < 8; ++k) {
        EXPECT_EQ(seen[k], std::clamp<int>(expected.outputs[k], -bound, bound)) << bound;
        limited += seen[k] != expected.outputs[k];
      }
    }
  }
  EXPECT_GT(limited, 100);
}

TEST_F(PolicyCore, CopiesItsInputsAtTheStart) {
  RandomNetworks networks{3707};
  load(image_of(networks.of({32, 5, 8}), 8));
  set(networks.inputs(32));
  const mlp::Outcome expected = mlp::evaluate(memory_, 8, inputs_);
  dut_.crc_value_i = expected.crc;
  start();
  set(networks.inputs(32));
  finish();
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(outputs()[i], std::max<int>(expected.outputs[i], -127));
}

TEST_F(PolicyCore, IgnoresAStartAndDataWhileItIsBusyAndSaysSo) {
  RandomNetworks networks{3708};
  load(image_of(networks.of({32, 20, 8}), 8));
  set(networks.inputs(32));
  const mlp::Outcome expected = expect_the_model();
  for (const bool data : {false, true}) {
    start();
    EXPECT_FALSE(dut_.status_refused_o);
    tick(3);
    set_address(0);
    if (data) {
      put(0);
    } else {
      start();
    }
    EXPECT_TRUE(dut_.status_refused_o);
    EXPECT_EQ(dut_.address_rdata_o, 0u);
    finish();
    EXPECT_EQ(dut_.cycles_value_o, expected.clocks);
    EXPECT_EQ(dut_.crc_read_value_o, expected.crc);
    EXPECT_TRUE(dut_.status_done_o);
    EXPECT_TRUE(dut_.status_refused_o);
  }
  start();
  dut_.wstrb_i = 7;
  put(0);
  EXPECT_FALSE(dut_.status_refused_o) << "no whole word";
}

TEST_F(PolicyCore, StoresWholeWordsAndCountsThem) {
  set_address(0xABC);
  EXPECT_EQ(dut_.address_rdata_o, 0xABCu);
  put(1);
  put(2);
  EXPECT_EQ(dut_.address_rdata_o, 0xABEu);
  dut_.wstrb_i = 0b1110;
  put(3);
  EXPECT_EQ(dut_.address_rdata_o, 0xABEu);
  set_address(0x123);
  EXPECT_EQ(dut_.address_rdata_o, 0x1BEu) << "byte 1";
  dut_.wstrb_i = 0b0001;
  set_address(0x123);
  EXPECT_EQ(dut_.address_rdata_o, 0x123u) << "byte 0";
  dut_.wstrb_i = 0xF;
  set_address(4095);
  put(4);
  EXPECT_EQ(dut_.address_rdata_o, 0u);
}

TEST_F(PolicyCore, ForgetsTheLastOutputsAtAStart) {
  set_neuron(20, 0x8000, 0);
  run();
  EXPECT_EQ(outputs()[0], 10);
  start();
  EXPECT_EQ(dut_.output_values_o, 0U);
  EXPECT_FALSE(dut_.status_done_o);
  finish();
  EXPECT_EQ(outputs()[0], 10);
  dut_.crc_value_i ^= 1u;
  run();
  EXPECT_EQ(dut_.output_values_o, 0U);
}

TEST_F(PolicyCore, ReportsTheEndOnceAndInterruptsWhileTheEventIsSet) {
  set_neuron(20, 0x8000, 0);
  start();
  int events = 0;
  for (int i = 0; i < 40; ++i) {
    events += dut_.event_ended_set_o;
    tick();
  }
  EXPECT_EQ(events, 1);
  for (const int irq : {0, 1}) {
    for (const int ended : {0, 1}) {
      dut_.ctrl_irq_i = static_cast<std::uint8_t>(irq);
      dut_.event_ended_i = static_cast<std::uint8_t>(ended);
      dut_.eval();
      tick();
      EXPECT_EQ(dut_.irq_o, irq & ended);
    }
  }
}

TEST_F(PolicyCore, NeedsItsClockFromTheStartToTheInterruptOnly) {
  set_neuron(20, 0x8000, 0);
  tick(2);
  EXPECT_FALSE(dut_.active_o);
  start();
  int clocks = 0, until_the_event = 0;
  for (; dut_.active_o && clocks < kTimeout; ++clocks) {
    if (dut_.event_ended_set_o) until_the_event = clocks;
    tick();
  }
  EXPECT_EQ(until_the_event, dut_.cycles_value_o);
  EXPECT_EQ(clocks, until_the_event + 2);
}

}  // namespace
}  // namespace armature::test
