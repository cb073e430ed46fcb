// Fixture of axi_lite_xbar: three slaves in C++ that accept and answer whenever they like, and that check what a slave
// may expect of its master.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <utility>

#include "Vaxi_lite_xbar.h"
#include "tests/support/axi_stall_test.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::test {

inline constexpr std::size_t kSlaves = 3;
// As in model_axi_lite_xbar (bus.cmake).
inline constexpr std::array<std::uint32_t, kSlaves> kBase{0x4280'0000u, 0x43C1'0000u, 0x43C2'0000u};
inline constexpr std::uint32_t kSize = 0x1'0000u;

inline std::optional<std::size_t> slave_of(std::uint32_t addr) {
  for (std::size_t i = 0; i < kSlaves; ++i) {
    if (addr - kBase[i] < kSize) return i;
  }
  return std::nullopt;
}

// What a slave answers is a function of slave and address, so that a misrouted response shows.
inline AxiResp response_of(std::size_t slave, std::uint32_t offset) {
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
    // A slave that shows a response before it has the request is given up, and the request is withdrawn.
    const std::uint32_t b_shown = dut_.m_axi_bvalid_i, r_shown = dut_.m_axi_rvalid_i;
    tick();
    if (!dut_.rst_ni) {
      slaves_ = {};
      dut_.m_axi_bvalid_i = dut_.m_axi_rvalid_i = 0;
      dut_.m_axi_awready_i = dut_.m_axi_wready_i = dut_.m_axi_arready_i = 0;
      dut_.eval();
      return;
    }
    expect_held(before, aw_taken | b_shown, w_taken | b_shown, ar_taken | r_shown);
    for (std::size_t i = 0; i < kSlaves; ++i) {
      Slave& slave = slaves_[i];
      if (b_taken & bit(i) & ~write_responses_stay_) set_bvalid(i, false);
      if (r_taken & bit(i) & ~read_responses_stay_) set_rvalid(i, false);
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

  std::array<Slave, kSlaves> slaves_;
  std::uint32_t writes_stuck_ = 0, reads_stuck_ = 0;  // bit i: slave i does not answer that direction
  // Bit i: slave i shows its next response for good.
  std::uint32_t write_responses_stay_ = 0, read_responses_stay_ = 0;

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

  // `aw_taken` and so on: the ports at which the request of before may end.
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
    if (!(writes_stuck_ & bit(i)) && !slave.aw.empty() && !slave.w.empty() && !(dut_.m_axi_bvalid_i & bit(i)) &&
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
    if (!(reads_stuck_ & bit(i)) && !slave.ar.empty() && !(dut_.m_axi_rvalid_i & bit(i)) && noise_.below(3) == 0) {
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

}  // namespace armature::test
