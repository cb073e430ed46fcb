// axi_lite_slave against a register file in C++ that keeps the contract of the strobe bus and no more: reg_werr_i is
// noise except in the one clock in which it means something.
#include <map>

#include "Vaxi_lite_slave.h"
#include "tests/support/axi_stall_test.hpp"

namespace armature::test {
namespace {

constexpr std::uint32_t kWords = 8;              // mapped registers: offsets 0 .. 4*kWords-1
constexpr std::uint32_t kBadData = 0xBADACCE5u;  // what an unmapped read returns

std::uint32_t merge(std::uint32_t old, std::uint32_t data, unsigned strobe) {
  for (unsigned byte = 0; byte < 4; ++byte) {
    const std::uint32_t mask = 0xFFu << (8 * byte);
    if (strobe >> byte & 1u) old = (old & ~mask) | (data & mask);
  }
  return old;
}

class AxiLiteSlaveTest : public AxiStallTest<Vaxi_lite_slave> {
 protected:
  static bool mapped(std::uint32_t addr) { return addr < 4 * kWords; }

  void clock() override {
    const bool we = dut_.reg_we_o, re = dut_.reg_re_o;
    const std::uint32_t waddr = dut_.reg_waddr_o, raddr = dut_.reg_raddr_o;
    if (we && dut_.rst_ni) {
      ++writes_;
      if (mapped(waddr)) words_[waddr / 4] = merge(words_[waddr / 4], dut_.reg_wdata_o, dut_.reg_wstrb_o);
    }
    if (re && dut_.rst_ni) ++reads_;
    tick();
    dut_.reg_werr_i = we ? !mapped(waddr) : noise_.below(2) != 0;
    if (re) {
      dut_.reg_rdata_i = mapped(raddr) ? words_[raddr / 4] : kBadData;
      dut_.reg_rerr_i = !mapped(raddr);
    }
    dut_.eval();
  }

  // A response that nobody takes must not hold up the other direction.
  void expect_second_answered(bool read_first) {
    dut_.s_axi_rready_i = dut_.s_axi_bready_i = 0;
    for (const bool read : {read_first, !read_first}) {
      dut_.s_axi_arvalid_i = read;
      dut_.s_axi_awvalid_i = dut_.s_axi_wvalid_i = !read;
      clock();
      dut_.s_axi_arvalid_i = dut_.s_axi_awvalid_i = dut_.s_axi_wvalid_i = 0;
      for (int i = 0; i < 10; ++i) clock();
      EXPECT_TRUE(read ? dut_.s_axi_rvalid_o : dut_.s_axi_bvalid_o);
    }
    EXPECT_TRUE(dut_.s_axi_rvalid_o && dut_.s_axi_bvalid_o);
  }

  std::map<std::uint32_t, std::uint32_t> words_;
  std::int64_t writes_ = 0, reads_ = 0;  // strobes seen
  SplitMix noise_{7};
};
INSTANTIATE_AXI_STALLS(AxiLiteSlaveTest);

TEST_P(AxiLiteSlaveTest, WritesThenReadsBack) {
  for (std::uint32_t i = 0; i < kWords; ++i) EXPECT_EQ(axi_.write(4 * i, 0x1111'1111u * i), AxiResp::kOkay);
  for (std::uint32_t i = 0; i < kWords; ++i) {
    EXPECT_EQ(axi_.read(4 * i), (AxiReadResult{AxiResp::kOkay, 0x1111'1111u * i}));
  }
  EXPECT_EQ(writes_, kWords);
  EXPECT_EQ(reads_, kWords);
}

TEST_P(AxiLiteSlaveTest, EveryByteStrobeReachesTheRegisters) {
  for (unsigned strobe = 0; strobe < 16; ++strobe) {
    axi_.write(8, 0xAABB'CCDDu);
    EXPECT_EQ(axi_.write(8, 0x1122'3344u, strobe), AxiResp::kOkay) << "strobe " << strobe;
    EXPECT_EQ(axi_.read(8).data, merge(0xAABB'CCDDu, 0x1122'3344u, strobe)) << "strobe " << strobe;
  }
  EXPECT_EQ(writes_, 32) << "a write without byte strobes is still one strobe and one response";
}

TEST_P(AxiLiteSlaveTest, ErrorOfTheRegisterFileIsSlvErr) {
  EXPECT_EQ(axi_.write(4 * kWords, 1), AxiResp::kSlvErr);
  EXPECT_EQ(axi_.write(0, 5), AxiResp::kOkay);
  EXPECT_EQ(axi_.read(0xFFFC), (AxiReadResult{AxiResp::kSlvErr, kBadData}));
  EXPECT_EQ(axi_.read(0), (AxiReadResult{AxiResp::kOkay, 5}));
}

TEST_P(AxiLiteSlaveTest, PassesUnalignedAddressesOn) {
  axi_.write(0x10, 0x0102'0304u);
  EXPECT_EQ(axi_.write(0x13, 0xFF00'0000u, 0x8), AxiResp::kOkay);
  EXPECT_EQ(axi_.read(0x11), (AxiReadResult{AxiResp::kOkay, 0xFF02'0304u}));
}

TEST_P(AxiLiteSlaveTest, QueuedRequestsAreNeitherLostNorPairedWrongly) {
  for (std::uint32_t i = 0; i < 40; ++i) axi_.post_write(4 * (i % kWords), 0x100u + i);
  axi_.drain();
  EXPECT_EQ(axi_.write_answers, std::deque<AxiResp>(40, AxiResp::kOkay));
  EXPECT_EQ(writes_, 40);
  for (std::uint32_t i = 0; i < kWords; ++i) EXPECT_EQ(words_[i], 0x100u + 32 + i);
}

TEST_P(AxiLiteSlaveTest, ReadsAndWritesOverlap) {
  for (std::uint32_t i = 0; i < 20; ++i) {
    axi_.post_write(4, i);
    axi_.post_read(i % 3 == 0 ? 4 * kWords : 0);
  }
  axi_.drain();
  EXPECT_EQ(axi_.write_answers.size(), 20u);
  ASSERT_EQ(axi_.read_answers.size(), 20u);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(axi_.read_answers[i].resp, i % 3 == 0 ? AxiResp::kSlvErr : AxiResp::kOkay) << "read " << i;
  }
}

TEST_P(AxiLiteSlaveTest, AStalledReadDoesNotBlockAWrite) {
  expect_second_answered(true);
}
TEST_P(AxiLiteSlaveTest, AStalledWriteDoesNotBlockARead) {
  expect_second_answered(false);
}

TEST_P(AxiLiteSlaveTest, ResetForgetsWhatIsInFlight) {
  for (int clocks = 0; clocks < 12; ++clocks) {
    axi_.post_write(0, 1);
    axi_.post_write(4, 2);
    axi_.post_read(0);
    axi_.step(clocks);
    dut_.rst_ni = 0;
    axi_.step(2);
    dut_.rst_ni = 1;
    const auto strobes = writes_ + reads_;
    axi_.step(20);  // the driver reports a response without a request
    EXPECT_EQ(writes_ + reads_, strobes) << "a request survived a reset after " << clocks << " clocks";
    EXPECT_EQ(axi_.write(8, 0x77), AxiResp::kOkay);
    EXPECT_EQ(axi_.read(8), (AxiReadResult{AxiResp::kOkay, 0x77}));
  }
}

TEST_P(AxiLiteSlaveTest, RandomTrafficMatchesASoftwareModel) {
  std::map<std::uint32_t, std::uint32_t> model;
  for (int round = 0; round < 300; ++round) {
    std::deque<AxiResp> expected;
    const unsigned writes = axi_.random().below(4);
    for (unsigned i = 0; i < writes; ++i) {
      const std::uint32_t addr = axi_.random().below(4 * kWords + 12), strobe = axi_.random().below(16);
      const auto data = static_cast<std::uint32_t>(axi_.random().next());
      axi_.post_write(addr, data, strobe);
      expected.push_back(mapped(addr) ? AxiResp::kOkay : AxiResp::kSlvErr);
      if (mapped(addr)) model[addr / 4] = merge(model[addr / 4], data, strobe);
    }
    axi_.drain();
    EXPECT_EQ(axi_.write_answers, expected) << "round " << round;
    axi_.write_answers.clear();

    std::deque<AxiReadResult> read;
    const unsigned reads = axi_.random().below(4);
    for (unsigned i = 0; i < reads; ++i) {
      const std::uint32_t addr = axi_.random().below(4 * kWords + 12);
      axi_.post_read(addr);
      read.push_back(mapped(addr) ? AxiReadResult{AxiResp::kOkay, model[addr / 4]}
                                  : AxiReadResult{AxiResp::kSlvErr, kBadData});
    }
    axi_.drain();
    EXPECT_EQ(axi_.read_answers, read) << "round " << round;
    axi_.read_answers.clear();
  }
}

}  // namespace
}  // namespace armature::test
