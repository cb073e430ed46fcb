// axi_lite_xbar: routes, answers, resets and random traffic.
#include <deque>
#include <map>

#include "tests/rtl/axi_xbar_fixture.hpp"

namespace armature::test {
namespace {

INSTANTIATE_AXI_STALLS(AxiXbarTest);

TEST_P(AxiXbarTest, RoutesEveryAccessToItsSlave) {
  for (std::size_t i = 0; i < kSlaves; ++i) {
    for (const std::uint32_t offset : {0x0u, 0x40u, 0xFFFCu}) {
      const auto data = static_cast<std::uint32_t>(0xA000'0000u + (i << 16) + offset);
      EXPECT_EQ(axi_.write(kBase[i] + offset, data), response_of(i, offset));
      EXPECT_EQ(axi_.read(kBase[i] + offset), (AxiReadResult{response_of(i, offset), data}));
      EXPECT_EQ(slaves_[i].words[offset], data);
    }
    EXPECT_EQ(slaves_[i].writes, 3);
    EXPECT_EQ(slaves_[i].reads, 3);
  }
}

TEST_P(AxiXbarTest, UnclaimedAddressesAnswerDecErrAndReachNoSlave) {
  for (const std::uint32_t addr : {0x0u, 0x427F'FFFCu, 0x4281'0000u, 0x43C0'FFFCu, 0x43C3'0000u, 0xC280'0000u,
                                   0x4280'0000u ^ 0x0400'0000u, 0xFFFF'FFFCu}) {
    EXPECT_EQ(axi_.write(addr, 1), AxiResp::kDecErr) << std::hex << addr;
    EXPECT_EQ(axi_.read(addr), (AxiReadResult{AxiResp::kDecErr, 0})) << std::hex << addr;
  }
  for (const Slave& slave : slaves_) EXPECT_EQ(slave.writes + slave.reads, 0);
  EXPECT_EQ(axi_.write(kBase[0] + 4, 1), AxiResp::kOkay) << "the crossbar goes on after a decode error";
}

TEST_P(AxiXbarTest, ByteStrobesPassThrough) {
  for (unsigned strobe = 0; strobe < 16; ++strobe) {
    axi_.write(kBase[1] + 8, 0);
    axi_.write(kBase[1] + 8, 0xFFFF'FFFFu, strobe);
    std::uint32_t expected = 0;
    for (unsigned byte = 0; byte < 4; ++byte) {
      if (strobe >> byte & 1u) expected |= 0xFFu << (8 * byte);
    }
    EXPECT_EQ(axi_.read(kBase[1] + 8).data, expected) << "strobe " << strobe;
  }
}

TEST_P(AxiXbarTest, UnalignedAddressesReachTheSlaveWhole) {
  EXPECT_EQ(axi_.write(kBase[2] + 0x33, 0x1234'5678u), response_of(2, 0x33));
  EXPECT_EQ(axi_.read(kBase[2] + 0x31), (AxiReadResult{response_of(2, 0x31), 0x1234'5678u}));
  EXPECT_EQ(slaves_[2].last_awaddr, 0x33u);
  EXPECT_EQ(slaves_[2].last_araddr, 0x31u);
}

TEST_P(AxiXbarTest, ResetForgetsWhatIsInFlight) {
  for (int clocks = 0; clocks < 16; ++clocks) {
    axi_.post_write(kBase[0], 1);
    axi_.post_write(0, 1);
    axi_.post_read(kBase[2]);
    axi_.post_read(0);
    axi_.step(clocks);
    dut_.rst_ni = 0;
    axi_.step(2);
    dut_.rst_ni = 1;
    axi_.step(20);  // the driver reports a response without a request
    for (const Slave& slave : slaves_) EXPECT_EQ(slave.writes + slave.reads, 0) << "after " << clocks << " clocks";
    EXPECT_EQ(axi_.write(kBase[1] + 4, 0x77), response_of(1, 4));
    EXPECT_EQ(axi_.read(kBase[1] + 4).data, 0x77u);
  }
}

// Up to eight accesses at once. Concurrent reads use the lower half of each block, writes the upper half, so that the
// order between the two directions cannot matter; after each round everything written is read back.
TEST_P(AxiXbarTest, RandomTrafficMatchesASoftwareModel) {
  constexpr std::uint32_t kUpper = 0x8000;
  std::map<std::uint32_t, std::uint32_t> model;
  for (int round = 0; round < 150; ++round) {
    std::deque<AxiResp> writes;
    std::deque<AxiReadResult> reads;
    for (unsigned i = axi_.random().below(9); i > 0; --i) {
      const std::uint32_t region = axi_.random().below(kSlaves + 1);
      const std::uint32_t base = region < kSlaves ? kBase[region] : 0x4300'0000u;
      const std::uint32_t offset = 4 * axi_.random().below(16);
      const auto data = static_cast<std::uint32_t>(axi_.random().next());
      const auto slave = slave_of(base);
      if (axi_.random().below(2) != 0) {
        axi_.post_write(base + kUpper + offset, data);
        writes.push_back(slave ? response_of(*slave, kUpper + offset) : AxiResp::kDecErr);
        if (slave) model[base + kUpper + offset] = data;
      } else {
        axi_.post_read(base + offset);
        reads.push_back({slave ? response_of(*slave, offset) : AxiResp::kDecErr, 0});
      }
    }
    axi_.drain();
    EXPECT_EQ(axi_.write_answers, writes) << "round " << round;
    EXPECT_EQ(axi_.read_answers, reads) << "round " << round;
    axi_.write_answers.clear();
    axi_.read_answers.clear();
    for (const auto& [addr, data] : model) ASSERT_EQ(axi_.read(addr).data, data) << "round " << round;
  }
}

}  // namespace
}  // namespace armature::test
