// The model of the slave port against the verilated axi_lite_slave: the pins, and the accesses of every edge.
// Everything that means nothing is noise: the answers without an access, the payload of a channel without VALID, a
// READY without a response.
#include <cstdint>

#include "Vaxi_lite_slave.h"
#include "cosim/model/bus_port.hpp"
#include "tests/support/split_mix.hpp"
#include "tests/support/verilated_test.hpp"

namespace armature::test {
namespace {

using cosim::AxiMasterPins;
using cosim::AxiSlavePins;
using cosim::model::Answer;
using cosim::model::BusPort;
using cosim::model::Strobes;

class BusPortLockstep : public VerilatedTest<Vaxi_lite_slave> {
 protected:
  std::uint32_t noise() { return static_cast<std::uint32_t>(random_.next()); }
  bool coin() { return random_.below(2) != 0; }

  void restart() {
    every_ = needed_ = {};
    pins_ = {};
    for (std::uint32_t& chance : chance_) chance = random_.below(2) != 0 ? 1 + random_.below(3) : 1 + random_.below(40);
    drive({});
    dut_.reg_werr_i = dut_.reg_rerr_i = 0;
    dut_.reg_rdata_i = 0;
    reset();
    dut_.eval();
  }

  void drive(const AxiMasterPins& m) {
    dut_.s_axi_awaddr_i = m.awaddr & 0xFFFF;
    dut_.s_axi_awvalid_i = m.awvalid;
    dut_.s_axi_wdata_i = m.wdata;
    dut_.s_axi_wstrb_i = m.wstrb;
    dut_.s_axi_wvalid_i = m.wvalid;
    dut_.s_axi_bready_i = m.bready;
    dut_.s_axi_araddr_i = m.araddr & 0xFFFF;
    dut_.s_axi_arvalid_i = m.arvalid;
    dut_.s_axi_rready_i = m.rready;
  }

  // Levels of a master that keeps the rules of AXI4-Lite and no more: VALID stays until READY, and a channel may offer
  // its next transfer while the response to the last one is still to come. `chance_`: 1 of so many clocks.
  void offer() {
    if (!pins_.awvalid) {
      pins_.awvalid = random_.below(chance_[0]) == 0;
      pins_.awaddr = noise();
    }
    if (!pins_.wvalid) {
      pins_.wvalid = random_.below(chance_[1]) == 0;
      pins_.wdata = noise();
      pins_.wstrb = static_cast<std::uint8_t>(noise() & 0xF);
    }
    if (!pins_.arvalid) {
      pins_.arvalid = random_.below(chance_[2]) == 0;
      pins_.araddr = noise();
    }
    pins_.bready = random_.below(chance_[3]) == 0;
    pins_.rready = random_.below(chance_[4]) == 0;
  }
  void finish_transfers(const AxiSlavePins& slave) {
    if (slave.awready) pins_.awvalid = false;
    if (slave.wready) pins_.wvalid = false;
    if (slave.arready) pins_.arvalid = false;
  }

  // One edge of the port, of a model that computes every edge, and of one that computes the edges it must.
  void clock() {
    const AxiMasterPins& in = pins_;
    const Strobes strobes = every_.strobes();
    const AxiSlavePins before = every_.pins();
    const Answer answer{.rdata = noise(), .rerr = coin(), .werr = coin()};
    count(before, strobes);
    drive(in);
    dut_.eval();
    ASSERT_EQ(bool{dut_.active_o != 0}, every_.is_active(in)) << "edge " << cycle_;
    tick();
    // The register file answers in the clock after the access, and keeps the data until the next read.
    dut_.reg_werr_i = strobes.write ? answer.werr : coin();
    if (strobes.read || before.arready) {
      dut_.reg_rdata_i = answer.rdata;
      dut_.reg_rerr_i = answer.rerr;
    }
    dut_.eval();
    if (needed_.is_active(in)) needed_.edge(in, answer);
    every_.edge(in, answer);
    finish_transfers(before);
    for (const BusPort* port : {&every_, &needed_}) expect_equal(*port);
  }

  void expect_equal(const BusPort& port) {
    const AxiSlavePins& pins = port.pins();
    ASSERT_EQ(bool{dut_.s_axi_awready_o != 0}, pins.awready) << "edge " << cycle_;
    ASSERT_EQ(bool{dut_.s_axi_wready_o != 0}, pins.wready) << "edge " << cycle_;
    ASSERT_EQ(bool{dut_.s_axi_arready_o != 0}, pins.arready) << "edge " << cycle_;
    ASSERT_EQ(bool{dut_.s_axi_bvalid_o != 0}, pins.bvalid) << "edge " << cycle_;
    ASSERT_EQ(bool{dut_.s_axi_rvalid_o != 0}, pins.rvalid) << "edge " << cycle_;
    if (pins.bvalid) ASSERT_EQ(dut_.s_axi_bresp_o, pins.bresp) << "edge " << cycle_;
    if (pins.rvalid) {
      ASSERT_EQ(dut_.s_axi_rdata_o, pins.rdata) << "edge " << cycle_;
      ASSERT_EQ(dut_.s_axi_rresp_o, pins.rresp) << "edge " << cycle_;
    }
    const Strobes& strobes = port.strobes();
    ASSERT_EQ(bool{dut_.reg_we_o != 0}, strobes.write) << "edge " << cycle_;
    ASSERT_EQ(bool{dut_.reg_re_o != 0}, strobes.read) << "edge " << cycle_;
    if (strobes.write) {
      ASSERT_EQ(dut_.reg_waddr_o, strobes.waddr) << "edge " << cycle_;
      ASSERT_EQ(dut_.reg_wdata_o, strobes.wdata) << "edge " << cycle_;
      ASSERT_EQ(dut_.reg_wstrb_o, strobes.wstrb) << "edge " << cycle_;
    }
    if (strobes.read) ASSERT_EQ(dut_.reg_raddr_o, strobes.raddr) << "edge " << cycle_;
  }

  // What the coming edge finds.
  void count(const AxiSlavePins& slave, const Strobes& strobes) {
    const AxiMasterPins& in = pins_;
    const bool address = in.awvalid && slave.awready, data = in.wvalid && slave.wready;
    if (address && data) ++at_once_;
    if (address && !data && slave.wready) ++address_first_;
    if (data && !address && slave.awready) ++data_first_;
    if (slave.bvalid && !in.bready) ++b_waits_;
    if (slave.rvalid && !in.rready) ++r_waits_;
    if (slave.bvalid && slave.bresp != 0) ++write_errors_;
    if (slave.rvalid && slave.rresp != 0) ++read_errors_;
    if (strobes.read && strobes.write) ++both_;
    if (slave.bvalid && in.awvalid && in.wvalid) ++next_writes_;
    if (slave.rvalid && in.arvalid) ++next_reads_;
  }

  static constexpr std::uint64_t kSeed = 2021;
  SplitMix random_{kSeed};
  AxiMasterPins pins_;
  std::array<std::uint32_t, 5> chance_{};
  BusPort every_, needed_;
  int at_once_ = 0, address_first_ = 0, data_first_ = 0, b_waits_ = 0, r_waits_ = 0;
  int write_errors_ = 0, read_errors_ = 0, both_ = 0, next_writes_ = 0, next_reads_ = 0;
};

TEST_F(BusPortLockstep, PinsAndAccessesAreThoseOfThePortInEveryClock) {
  SCOPED_TRACE(::testing::Message() << "seed " << kSeed);
  for (int stretch = 0; stretch < 1'000; ++stretch) {
    restart();
    for (int i = 0; i < 500; ++i) {
      offer();
      clock();
      if (HasFailure()) return;
    }
  }
  for (const int seen : {at_once_, address_first_, data_first_, b_waits_, r_waits_, write_errors_, read_errors_, both_,
                         next_writes_, next_reads_}) {
    EXPECT_GE(seen, 1'000);
  }
}

}  // namespace
}  // namespace armature::test
