// Fixture of policy_core with any number of lanes, with its model beside it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cosim/model/policy_mlp/network_run.hpp"
#include "tests/support/mlp_images.hpp"
#include "tests/support/verilated_test.hpp"

namespace armature::test {

namespace mlp = cosim::model::mlp;

template <class Dut, std::size_t Lanes>
class PolicyCoreFixture : public VerilatedTest<Dut> {
 protected:
  PolicyCoreFixture() {
    this->dut_.ctrl_start_i = this->dut_.ctrl_irq_i = this->dut_.event_ended_i = 0;
    this->dut_.data_we_i = this->dut_.data_re_i = this->dut_.address_we_i = this->dut_.address_re_i = 0;
    this->dut_.id_re_i = 0;
    this->dut_.wdata_i = this->dut_.crc_value_i = 0;
    this->dut_.wstrb_i = 0xF;
    this->dut_.bound_value_i = 127;
    for (std::size_t i = 0; i < 8; ++i) this->dut_.input_values_i[i] = 0;
    this->reset();
  }

  void set_address(std::uint32_t word) {
    this->dut_.wdata_i = word;
    this->dut_.address_we_i = 1;
    this->tick();
    this->dut_.address_we_i = 0;
  }
  // A write to DATA.
  void put(std::uint32_t word) {
    this->dut_.wdata_i = word;
    this->dut_.data_we_i = 1;
    this->tick();
    this->dut_.data_we_i = 0;
  }
  void load(const TestImage& image) {
    set_address(0);
    for (std::size_t i = 0; i < image.size(); ++i) {
      put(image[i]);
      memory_[i] = image[i];
    }
  }
  void set(const std::vector<std::int8_t>& inputs) {
    inputs_ = {};
    std::ranges::copy(inputs, inputs_.begin());
    for (std::size_t i = 0; i < 8; ++i) {
      std::uint32_t word = 0;
      for (std::size_t k = 0; k < 4; ++k)
        word |= std::uint32_t{static_cast<std::uint8_t>(inputs_[4 * i + k])} << (8 * k);
      this->dut_.input_values_i[i] = word;
    }
  }
  void start() {
    this->dut_.ctrl_start_i = 1;
    this->tick();
    this->dut_.ctrl_start_i = 0;
  }
  // Returns the clocks that were busy.
  int finish() {
    int clocks = 0;
    for (; this->dut_.status_busy_o && clocks < kTimeout; ++clocks) this->tick();
    return clocks;
  }
  int run() {
    start();
    return finish();
  }
  [[nodiscard]] std::vector<std::int8_t> outputs() {
    std::vector<std::int8_t> values;
    for (std::size_t i = 0; i < 8; ++i)
      values.push_back(static_cast<std::int8_t>(this->dut_.output_values_o >> (8 * i)));
    return values;
  }

  // Runs the image in the memory with the CRC of the model. All results are those of the model.
  mlp::Outcome expect_the_model() {
    const mlp::Outcome expected = mlp::evaluate(memory_, Lanes, inputs_);
    this->dut_.crc_value_i = expected.crc;
    EXPECT_EQ(run(), expected.clocks);
    EXPECT_EQ(this->dut_.cycles_value_o, expected.clocks);
    EXPECT_EQ(this->dut_.crc_read_value_o, expected.crc);
    EXPECT_EQ(this->dut_.status_corrupt_o, 0);
    EXPECT_EQ(this->dut_.status_malformed_o, expected.malformed);
    EXPECT_EQ(this->dut_.status_done_o, !expected.malformed);
    const std::vector<std::int8_t> seen = outputs();
    for (std::size_t i = 0; i < seen.size(); ++i) {
      EXPECT_EQ(seen[i], expected.malformed ? 0 : std::max<int>(expected.outputs[i], -127)) << i;
    }
    return expected;
  }

  // A network against plain arithmetic and the model.
  void expect_plain_arithmetic(const TestNetwork& network, const std::vector<std::int8_t>& inputs) {
    load(image_of(network, Lanes));
    set(inputs);
    EXPECT_FALSE(expect_the_model().malformed);
    const std::vector<std::int8_t> expected = outputs_of(network, inputs);
    const std::vector<std::int8_t> seen = outputs();
    for (std::size_t i = 0; i < seen.size(); ++i) {
      EXPECT_EQ(seen[i], i < expected.size() ? std::max<int>(expected[i], -127) : 0) << "output " << i;
    }
  }

  static constexpr int kTimeout = 1 + 16384 / static_cast<int>(Lanes) + 4 * mlp::kPipeline + 1;

  mlp::Memory memory_{};
  mlp::Inputs inputs_{};
};

}  // namespace armature::test
