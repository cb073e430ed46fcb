#include "cosim/bus/axi_lite_master.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace armature::cosim {
namespace {

// A slave with every freedom the protocol gives it: READY low until VALID or always high, any response delay.
struct FakeSlave {
  int accept_delay = 0;    // edges between VALID and READY
  int response_delay = 1;  // edges between acceptance and the response
  std::uint8_t resp = 0;
  bool dead = false;

  AxiSlavePins pins;
  int aw_wait = 0, w_wait = 0, ar_wait = 0, countdown = -1;
  bool aw = false, w = false;
  std::vector<std::uint32_t> written, read_addresses;

  // One clock edge with the master's pins as they were before it.
  void edge(const AxiMasterPins& m) {
    if (dead) return;
    const bool aw_fires = m.awvalid && pins.awready;
    const bool w_fires = m.wvalid && pins.wready;
    const bool ar_fires = m.arvalid && pins.arready;
    if (pins.bvalid && m.bready) pins.bvalid = false;
    if (pins.rvalid && m.rready) pins.rvalid = false;
    if (aw_fires) aw = true, written.push_back(m.awaddr);
    if (w_fires) w = true, written.push_back(m.wdata);
    if (aw && w && countdown < 0 && !pins.bvalid) countdown = response_delay;
    if (ar_fires) read_addresses.push_back(m.araddr), countdown = response_delay;
    if (countdown >= 0 && countdown-- == 0) {
      if (aw) {
        pins.bvalid = true, pins.bresp = resp, aw = w = false;
      } else {
        pins.rvalid = true, pins.rresp = resp,
        pins.rdata = 0xC0FFEE00u + static_cast<std::uint32_t>(read_addresses.size());
      }
    }
    pins.awready = !aw_fires && m.awvalid && aw_wait++ >= accept_delay;
    pins.wready = !w_fires && m.wvalid && w_wait++ >= accept_delay;
    pins.arready = !ar_fires && m.arvalid && ar_wait++ >= accept_delay;
    if (aw_fires) aw_wait = 0;
    if (w_fires) w_wait = 0;
    if (ar_fires) ar_wait = 0;
  }
};

struct Outcome {
  std::optional<BusResponse> response;
  std::int64_t cycles = 0;
};

// Also checks what a master must keep: VALID and its payload stay until the transfer.
Outcome transact(AxiLiteMaster& master, FakeSlave& slave, const BusRequest& request, Cycles start) {
  master.start(request, start);
  for (std::int64_t c = 0; c < 5000; ++c) {
    const Cycles now = start + Cycles{c};
    if (master.next_event() <= now) {
      const AxiMasterPins before = master.pins();
      if (const auto response = master.step(now, slave.pins)) return {response, c};
      (void)before;
    }
    const AxiMasterPins driven = master.pins();
    const AxiSlavePins seen = slave.pins;
    slave.edge(driven);
    if (driven.awvalid && !seen.awready) {
      AxiLiteMaster copy = master;
      (void)copy.step(now + Cycles{1}, slave.pins);
      EXPECT_TRUE(copy.pins().awvalid) << "AWVALID was taken back";
      EXPECT_EQ(copy.pins().awaddr, driven.awaddr);
    }
  }
  return {};
}

class AxiLiteMasterTest : public testing::TestWithParam<double> {
 protected:
  BusSpec spec{.latency_cycles = 6, .timeout_cycles = 1000, .stall_probability = GetParam()};
};

TEST_P(AxiLiteMasterTest, WritesAndReadsOnceEach) {
  AxiLiteMaster master{spec, 42};
  FakeSlave slave;
  for (std::uint32_t i = 0; i < 200; ++i) {
    slave.accept_delay = static_cast<int>(i % 4);
    slave.response_delay = static_cast<int>(i % 3);
    slave.written.clear();
    slave.read_addresses.clear();
    const auto write = transact(master, slave, {true, 0x1000 + 4 * i, 7 * i}, Cycles{1000 * i});
    ASSERT_TRUE(write.response);
    EXPECT_EQ(write.response->error, BusError::kNone);
    ASSERT_EQ(slave.written.size(), 2u);
    EXPECT_EQ(slave.written[0] + slave.written[1], 0x1000 + 4 * i + 7 * i);
    const auto read = transact(master, slave, {false, 0x2000 + 4 * i, 0}, Cycles{1000 * i + 500});
    ASSERT_TRUE(read.response);
    EXPECT_EQ(read.response->data, 0xC0FFEE01u);
    EXPECT_EQ(slave.read_addresses, (std::vector<std::uint32_t>{0x2000 + 4 * i}));
  }
}

INSTANTIATE_TEST_SUITE_P(Stalls, AxiLiteMasterTest, testing::Values(0.0, 0.3, 0.9));

TEST(AxiLiteMaster, StrobesTheBytesOfTheRequest) {
  for (const std::uint8_t strobes : {std::uint8_t{0x0}, std::uint8_t{0x4}, std::uint8_t{0xF}}) {
    AxiLiteMaster master{BusSpec{.latency_cycles = 0}, 1};
    master.start({.write = true, .addr = 4, .data = 1, .strobes = strobes}, Cycles{0});
    (void)master.step(Cycles{0}, {});
    ASSERT_TRUE(master.pins().wvalid);
    EXPECT_EQ(master.pins().wstrb, strobes);
  }
  EXPECT_EQ(BusRequest{}.strobes, 0xF) << "whole words unless said otherwise";
}

TEST(AxiLiteMaster, ChargesItsLatencyEachWay) {
  FakeSlave slave;
  AxiLiteMaster none{BusSpec{.latency_cycles = 0}, 1};
  AxiLiteMaster six{BusSpec{.latency_cycles = 6}, 1};
  const auto fast = transact(none, slave, {true, 4, 1}, Cycles{0});
  const auto slow = transact(six, slave, {true, 4, 1}, Cycles{0});
  EXPECT_EQ(slow.cycles, fast.cycles + 12);
}

TEST(AxiLiteMaster, ReportsErrorResponses) {
  AxiLiteMaster master{BusSpec{}, 1};
  FakeSlave slave;
  slave.resp = 0b10;
  EXPECT_EQ(transact(master, slave, {true, 4, 1}, Cycles{0}).response->error, BusError::kSlaveError);
  EXPECT_EQ(transact(master, slave, {false, 4, 1}, Cycles{100}).response->error, BusError::kSlaveError);
  slave.resp = 0b11;
  EXPECT_EQ(transact(master, slave, {true, 4, 1}, Cycles{200}).response->error, BusError::kDecodeError);
  EXPECT_EQ(transact(master, slave, {false, 4, 1}, Cycles{300}).response->error, BusError::kDecodeError);
}

TEST(AxiLiteMaster, TimesOutOnADeadSlave) {
  AxiLiteMaster master{BusSpec{.timeout_cycles = 100}, 1};
  FakeSlave slave;
  slave.dead = true;
  const auto outcome = transact(master, slave, {false, 4, 0}, Cycles{0});
  ASSERT_TRUE(outcome.response);
  EXPECT_EQ(outcome.response->error, BusError::kTimeout);
  EXPECT_EQ(outcome.cycles, 101);
}

TEST(AxiLiteMaster, TheSameSeedStallsTheSame) {
  const auto lengths = [](std::uint64_t seed) {
    AxiLiteMaster master{BusSpec{.stall_probability = 0.5}, seed};
    FakeSlave slave;
    std::vector<std::int64_t> cycles;
    for (int i = 0; i < 50; ++i) cycles.push_back(transact(master, slave, {i % 2 == 0, 4, 1}, Cycles{1000 * i}).cycles);
    return cycles;
  };
  EXPECT_EQ(lengths(7), lengths(7));
  EXPECT_NE(lengths(7), lengths(8));
}

}  // namespace
}  // namespace armature::cosim
