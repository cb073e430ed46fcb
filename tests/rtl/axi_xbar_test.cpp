// axi_lite_xbar in front of three slaves in C++ that accept and answer whenever they like, and that check what a slave
// may expect of its master.
#include <array>
#include <map>
#include <optional>

#include "Vaxi_lite_xbar.h"
#include "tests/support/axi_stall_test.hpp"

namespace armature::test {
namespace {

constexpr std::size_t kSlaves = 3;
constexpr std::array<std::uint32_t, kSlaves> kBase{0x4280'0000u, 0x43C1'0000u, 0x43C2'0000u};  // as model_axi_lite_xbar
constexpr std::uint32_t kSize = 0x1'0000u;

std::optional<std::size_t> slave_of(std::uint32_t addr) {
  for (std::size_t i = 0; i < kSlaves; ++i) {
    if (addr - kBase[i] < kSize) return i;
  }
  return std::nullopt;
}

// What a slave answers is a function of slave and address, so that a misrouted response shows.
AxiResp response_of(std::size_t slave, std::uint32_t offset) {
  return (offset >> 2) % 5 == slave ? AxiResp::kSlvErr : AxiResp::kOkay;
}

struct Slave {
  std::deque<std::uint32_t> aw, ar;  // accepted, unanswered
  std::deque<std::pair<std::uint32_t, unsigned>> w;
  std::map<std::uint32_t, std::uint32_t> words;
  std::int64_t writes = 0, reads = 0;
  std::uint32_t last_awaddr = 0, last_araddr = 0;  // all address bits, as they arrived
  std::uint32_t rdata = 0;
  AxiResp bresp = AxiResp::kOkay, rresp = AxiResp::kOkay;
};

class AxiXbarTest : public AxiStallTest<Vaxi_lite_xbar> {
 protected:
  static std::uint32_t bit(std::size_t i) { return 1u << i; }

  void clock() override {
    const Master before = master();
    const std::uint32_t b_taken = dut_.m_axi_bvalid_i & dut_.m_axi_bready_o;
    const std::uint32_t r_taken = dut_.m_axi_rvalid_i & dut_.m_axi_rready_o;
    const std::uint32_t aw_taken = before.awvalid & dut_.m_axi_awready_i;
    const std::uint32_t w_taken = before.wvalid & dut_.m_axi_wready_i;
    const std::uint32_t ar_taken = before.arvalid & dut_.m_axi_arready_i;
    tick();
    if (!dut_.rst_ni) {
      slaves_ = {};
      dut_.m_axi_bvalid_i = dut_.m_axi_rvalid_i = 0;
      dut_.m_axi_awready_i = dut_.m_axi_wready_i = dut_.m_axi_arready_i = 0;
      dut_.eval();
      return;
    }
    expect_held(before, aw_taken, w_taken, ar_taken);
    for (std::size_t i = 0; i < kSlaves; ++i) {
      Slave& slave = slaves_[i];
      if (b_taken & bit(i)) set_bvalid(i, false);
      if (r_taken & bit(i)) set_rvalid(i, false);
      if (aw_taken & bit(i)) slave.aw.push_back(slave.last_awaddr = before.awaddr[i]);
      if (w_taken & bit(i)) slave.w.emplace_back(before.wdata[i], before.wstrb[i]);
      if (ar_taken & bit(i)) slave.ar.push_back(slave.last_araddr = before.araddr[i]);
      answer(i, slave);
    }
    // READY of a slave may come and go as it likes, and independently of VALID.
    dut_.m_axi_awready_i = static_cast<CData>(noise_.below(8));
    dut_.m_axi_wready_i = static_cast<CData>(noise_.below(8));
    dut_.m_axi_arready_i = static_cast<CData>(noise_.below(8));
    dut_.eval();
  }

  // The answer of the slave comes too late.
  void expect_only_port_0_is_given_up() {
    writes_stuck_ = reads_stuck_ = false;
    axi_.step(50);
    const std::int64_t accesses = slaves_[0].writes + slaves_[0].reads;
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(axi_.write(kBase[0] + 4, 2), AxiResp::kSlvErr);
      EXPECT_EQ(axi_.read(kBase[0] + 4), (AxiReadResult{AxiResp::kSlvErr, 0}));
      EXPECT_EQ(axi_.write(kBase[2] + 4, 3), response_of(2, 4));
      EXPECT_EQ(axi_.read(kBase[2] + 4), (AxiReadResult{response_of(2, 4), 3}));
    }
    EXPECT_EQ(slaves_[0].writes + slaves_[0].reads, accesses) << "nothing is sent to it";
    dut_.rst_ni = 0;
    axi_.step(2);
    dut_.rst_ni = 1;
    EXPECT_EQ(axi_.write(kBase[0] + 4, 4), response_of(0, 4)) << "a reset gives it another chance";
    EXPECT_EQ(axi_.read(kBase[0] + 4), (AxiReadResult{response_of(0, 4), 4}));
  }

  std::array<Slave, kSlaves> slaves_;
  bool writes_stuck_ = false, reads_stuck_ = false;  // no slave answers that direction

 private:
  struct Master {
    std::uint32_t awvalid, wvalid, arvalid;  // bit i: port i
    std::array<std::uint32_t, kSlaves> awaddr, wdata, wstrb, araddr;
  };

  Master master() const {
    Master now{dut_.m_axi_awvalid_o, dut_.m_axi_wvalid_o, dut_.m_axi_arvalid_o, {}, {}, {}, {}};
    for (std::size_t i = 0; i < kSlaves; ++i) {
      now.awaddr[i] = dut_.m_axi_awaddr_o >> (16 * i) & 0xFFFF;
      now.wdata[i] = dut_.m_axi_wdata_o[i];
      now.wstrb[i] = dut_.m_axi_wstrb_o >> (4 * i) & 0xFu;
      now.araddr[i] = dut_.m_axi_araddr_o >> (16 * i) & 0xFFFF;
    }
    return now;
  }

  void expect_held(const Master& before, std::uint32_t aw_taken, std::uint32_t w_taken, std::uint32_t ar_taken) {
    const Master now = master();
    EXPECT_EQ(before.awvalid & ~aw_taken & ~now.awvalid, 0u) << "AWVALID dropped, clock " << cycle_;
    EXPECT_EQ(before.wvalid & ~w_taken & ~now.wvalid, 0u) << "WVALID dropped, clock " << cycle_;
    EXPECT_EQ(before.arvalid & ~ar_taken & ~now.arvalid, 0u) << "ARVALID dropped, clock " << cycle_;
    if (before.awvalid & ~aw_taken) {
      EXPECT_EQ(now.awaddr, before.awaddr);
    }
    if (before.wvalid & ~w_taken) {
      EXPECT_EQ(now.wdata, before.wdata);
      EXPECT_EQ(now.wstrb, before.wstrb);
    }
    if (before.arvalid & ~ar_taken) {
      EXPECT_EQ(now.araddr, before.araddr);
    }
  }

  void answer(std::size_t i, Slave& slave) {
    if (!writes_stuck_ && !slave.aw.empty() && !slave.w.empty() && !(dut_.m_axi_bvalid_i & bit(i)) &&
        noise_.below(3) == 0) {
      const auto [data, strobe] = slave.w.front();
      std::uint32_t& word = slave.words[slave.aw.front() & ~3u];
      for (unsigned byte = 0; byte < 4; ++byte) {
        const std::uint32_t mask = 0xFFu << (8 * byte);
        if (strobe >> byte & 1u) word = (word & ~mask) | (data & mask);
      }
      slave.bresp = response_of(i, slave.aw.front());
      slave.aw.pop_front();
      slave.w.pop_front();
      ++slave.writes;
      set_bvalid(i, true);
    }
    if (!reads_stuck_ && !slave.ar.empty() && !(dut_.m_axi_rvalid_i & bit(i)) && noise_.below(3) == 0) {
      slave.rdata = slave.words[slave.ar.front() & ~3u];
      slave.rresp = response_of(i, slave.ar.front());
      slave.ar.pop_front();
      ++slave.reads;
      set_rvalid(i, true);
    }
    put_responses();
  }

  // A payload without VALID is noise.
  void put_responses() {
    dut_.m_axi_bresp_i = dut_.m_axi_rresp_i = 0;
    for (std::size_t i = 0; i < kSlaves; ++i) {
      const bool b = dut_.m_axi_bvalid_i & bit(i), r = dut_.m_axi_rvalid_i & bit(i);
      const unsigned bresp = b ? static_cast<unsigned>(slaves_[i].bresp) : noise_.below(4);
      const unsigned rresp = r ? static_cast<unsigned>(slaves_[i].rresp) : noise_.below(4);
      dut_.m_axi_bresp_i = static_cast<CData>(dut_.m_axi_bresp_i | bresp << (2 * i));
      dut_.m_axi_rresp_i = static_cast<CData>(dut_.m_axi_rresp_i | rresp << (2 * i));
      dut_.m_axi_rdata_i[i] = r ? slaves_[i].rdata : static_cast<std::uint32_t>(noise_.next());
    }
  }

  void set_bvalid(std::size_t i, bool on) {
    dut_.m_axi_bvalid_i = static_cast<CData>(on ? dut_.m_axi_bvalid_i | bit(i) : dut_.m_axi_bvalid_i & ~bit(i));
  }
  void set_rvalid(std::size_t i, bool on) {
    dut_.m_axi_rvalid_i = static_cast<CData>(on ? dut_.m_axi_rvalid_i | bit(i) : dut_.m_axi_rvalid_i & ~bit(i));
  }

  SplitMix noise_{11};
};
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

// A slave that does not answer stops its own direction only, until the bus watchdog answers in its place. From then on
// nothing is sent to it.
TEST_P(AxiXbarTest, AHungReadDoesNotBlockWritesAndEndsWithAnError) {
  reads_stuck_ = true;
  axi_.post_read(kBase[0] + 4);
  for (int i = 0; i < 10; ++i) axi_.post_write(kBase[1] + 4, 1);
  axi_.step(100);
  EXPECT_TRUE(axi_.read_answers.empty());
  axi_.step(900);
  EXPECT_EQ(axi_.write_answers, std::deque<AxiResp>(10, response_of(1, 4)));
  EXPECT_EQ(axi_.read_answers, (std::deque<AxiReadResult>{{AxiResp::kSlvErr, 0}}));
  axi_.write_answers.clear();
  axi_.read_answers.clear();
  expect_only_port_0_is_given_up();
}

TEST_P(AxiXbarTest, AHungWriteDoesNotBlockReadsAndEndsWithAnError) {
  writes_stuck_ = true;
  axi_.post_write(kBase[0] + 4, 1);
  for (int i = 0; i < 10; ++i) axi_.post_read(kBase[1] + 4);
  axi_.step(100);
  EXPECT_TRUE(axi_.write_answers.empty());
  axi_.step(900);
  EXPECT_EQ(axi_.read_answers.size(), 10u);
  EXPECT_EQ(axi_.write_answers, (std::deque<AxiResp>{AxiResp::kSlvErr}));
  axi_.write_answers.clear();
  axi_.read_answers.clear();
  expect_only_port_0_is_given_up();
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
