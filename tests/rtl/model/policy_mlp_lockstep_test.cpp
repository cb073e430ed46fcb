// The model of policy_mlp against the verilated block, clock for clock.
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "Vpolicy_mlp.h"
#include "controller/regs/policy_mlp_regs.hpp"
#include "cosim/model/policy_mlp/policy_mlp.hpp"
#include "tests/rtl/model/block_lockstep.hpp"
#include "tests/support/mlp_images.hpp"

namespace armature::test {
namespace {

namespace map = regs::policy_mlp;
using cosim::model::PolicyInputs;
using cosim::model::PolicyMlp;

class PolicyMlpLockstep : public BlockLockstep<Vpolicy_mlp, PolicyMlp, PolicyInputs> {
 protected:
  std::uint16_t random_address() {
    if (random_.below(40) == 0) return static_cast<std::uint16_t>(random_.below(0x10000));
    if (random_.below(2) == 0) return static_cast<std::uint16_t>(random_.below(0x20));
    return static_cast<std::uint16_t>(random_.below(0x80));
  }
  // Networks that a start may follow at once, later, or in the middle; now and then with a wrong word or CRC.
  BusTraffic random_write() override {
    if (queue_.empty() && random_.below(starts_) == 0) post_network();
    if (!queue_.empty() && random_.below(24) != 0) {
      const BusTraffic next = queue_.back();
      queue_.pop_back();
      return next;
    }
    static constexpr std::uint32_t kOften[] = {map::kCtrlOffset, map::kEventOffset, map::kBoundOffset,
                                               map::kDataOffset};
    const std::uint16_t address =
        random_.below(2) == 0 ? static_cast<std::uint16_t>(kOften[random_.below(4)]) : random_address();
    BusTraffic write{.addr = address, .data = static_cast<std::uint32_t>(random_.next())};
    if (random_.below(4) == 0) write.wstrb = static_cast<std::uint8_t>(random_.below(16));
    return write;
  }
  std::uint16_t random_read() override { return random_address(); }
  void change_inputs() override {
    if (dut_.irq_o && !std::exchange(irq_, dut_.irq_o != 0)) ++irqs_;
    irq_ = dut_.irq_o != 0;
    const cosim::AxiSlavePins& pins = every_.port.pins();
    if (!pins.rvalid || pins.rresp != 0) return;
    const std::uint32_t read = every_.port.strobes().raddr & ~3u;
    if ((read == map::kOutputOffset || read == map::kOutputOffset + 4) && pins.rdata != 0) ++outputs_;
    if (read != map::kStatusOffset) return;
    refusals_ += (pins.rdata & map::kStatusRefusedMask) != 0;
    busy_ += (pins.rdata & map::kStatusBusyMask) != 0;
    corrupt_ += (pins.rdata & map::kStatusCorruptMask) != 0;
    malformed_ += (pins.rdata & map::kStatusMalformedMask) != 0;
  }
  void drive_inputs(Vpolicy_mlp& /*dut*/, const PolicyInputs& /*in*/) override {}
  std::string difference(const Vpolicy_mlp& dut, const PolicyMlp& block) override {
    if ((dut.irq_o != 0) == block.irq()) return {};
    std::ostringstream text;
    text << "irq RTL " << int{dut.irq_o} << " model " << block.irq();
    return text.str();
  }

  void post_network() {
    const auto add = [this](std::uint32_t offset, std::uint32_t value) {
      queue_.push_back({.addr = static_cast<std::uint16_t>(offset), .data = value});
    };
    // Small, so that there are many. A few have five layers.
    std::vector<std::size_t> sizes(2 + random_.below(5));
    for (std::size_t& size : sizes) size = 1 + random_.below(9);
    const TestImage image = image_of(networks_.of(sizes), PolicyMlp::kLanes);
    cosim::model::mlp::Memory memory{};
    std::copy(image.begin(), image.end(), memory.begin());
    const std::uint32_t crc = cosim::model::mlp::evaluate(memory, PolicyMlp::kLanes, {}).crc;
    // The last one is written first.
    for (int i = 0; i < 3; ++i) add(map::kCtrlOffset, map::kCtrlStartMask | random_.below(2) << 1);
    for (std::uint32_t i = 0; i < 4; ++i) add(map::kInputOffset + 4 * i, static_cast<std::uint32_t>(random_.next()));
    add(map::kBoundOffset, random_.below(128));
    add(map::kCrcOffset, random_.below(4) == 0 ? crc ^ 1u : crc);
    for (std::size_t i = image.size(); i-- > 0;) add(map::kDataOffset, image[i]);
    add(map::kAddressOffset, 0);
  }

  RandomNetworks networks_{3731};
  std::vector<BusTraffic> queue_;
  std::uint32_t starts_ = 1;
  bool irq_ = false;
  int irqs_ = 0, outputs_ = 0, refusals_ = 0, busy_ = 0, corrupt_ = 0, malformed_ = 0;
};

TEST_F(PolicyMlpLockstep, RandomTrafficIsThatOfTheBlockInEveryClock) {
  run(100'000, 1, 1);
  run(100'000, 12, 2);
  starts_ = 20;
  run(100'000, 20, 1);
  const std::pair<const char*, int> counts[]{
      {"interrupts", irqs_},       {"reads of outputs", outputs_},         {"reads of a refusal", refusals_},
      {"reads while busy", busy_}, {"reads of a corrupt image", corrupt_}, {"reads of a malformed image", malformed_}};
  for (const auto& [what, count] : counts) {
    RecordProperty(what, count);
    EXPECT_GE(count, 20) << "too few " << what;
  }
}

TEST_F(PolicyMlpLockstep, ABlockAtRestIsNotComputed) {
  run(10'000, 12, 2);
  queue_.clear();
  for (int clock = 0; clock < 3'000; ++clock) {
    master_.drive(1);
    step();
  }
  const std::int64_t before = needed_.computed;
  for (int clock = 0; clock < 10'000; ++clock) {
    master_.drive(1);
    step();
    ASSERT_EQ(compare(), "") << "edge " << cycle_;
  }
  EXPECT_EQ(needed_.computed, before);
}

}  // namespace
}  // namespace armature::test
