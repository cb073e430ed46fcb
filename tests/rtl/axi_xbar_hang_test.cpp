// axi_lite_xbar: slaves that do not answer in time, or whose responses stay. The bus watchdog answers in their place,
// and gives their ports up.
#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>

#include "tests/rtl/axi_xbar_fixture.hpp"

namespace armature::test {
namespace {

constexpr std::uint32_t kWord = 0x20;  // every slave answers OKAY here

class AxiXbarHang : public AxiXbarTest {
 protected:
  void restart() {
    dut_.rst_ni = 0;
    axi_.step(2);
    dut_.rst_ni = 1;
    writes_stuck_ = reads_stuck_ = 0;
    write_responses_stay_ = read_responses_stay_ = 0;
  }

  // Fills the data register of the crossbar with something that must not come back.
  void read_ones() {
    axi_.write(kBase[2] + kWord, 0xFFFF'FFFFu);
    EXPECT_EQ(axi_.read(kBase[2] + kWord).data, 0xFFFF'FFFFu);
  }

  // Whole requests that slave i has accepted.
  [[nodiscard]] std::int64_t accepted(std::size_t i) const {
    const Slave& slave = slaves_[i];
    return slave.writes + slave.reads + static_cast<std::int64_t>(slave.aw.size() + slave.ar.size());
  }

  // The ports with a bit in `ports` are given up: they get nothing and answer errors. The others work.
  void expect_given_up(std::uint32_t ports) {
    for (std::size_t i = 0; i < kSlaves; ++i) {
      SCOPED_TRACE(testing::Message() << "port " << i << ", given up " << ports);
      const bool works = !(ports & bit(i));
      const std::int64_t before = accepted(i);
      const auto data = static_cast<std::uint32_t>(axi_.random().next());
      EXPECT_EQ(axi_.write(kBase[i] + kWord, data), works ? AxiResp::kOkay : AxiResp::kSlvErr);
      EXPECT_EQ(axi_.read(kBase[i] + kWord),
                works ? (AxiReadResult{AxiResp::kOkay, data}) : (AxiReadResult{AxiResp::kSlvErr, 0}));
      EXPECT_EQ(accepted(i) - before, works ? 2 : 0);
    }
  }

  void expect_only_port_0_is_given_up() {
    writes_stuck_ = reads_stuck_ = 0;
    axi_.step(50);  // the answer of the slave comes too late
    for (int i = 0; i < 3; ++i) expect_given_up(bit(0));
    restart();
    expect_given_up(0);  // a reset gives it another chance
  }
};
INSTANTIATE_AXI_STALLS(AxiXbarHang);

// A slave that does not answer stops its own direction only, until the bus watchdog answers in its place. From then on
// nothing is sent to it.
TEST_P(AxiXbarHang, AHungReadDoesNotBlockWritesAndEndsWithAnError) {
  read_ones();
  reads_stuck_ = bit(0);
  axi_.post_read(kBase[0] + kWord);
  for (int i = 0; i < 10; ++i) axi_.post_write(kBase[1] + kWord, 1);
  axi_.step(100);
  EXPECT_TRUE(axi_.read_answers.empty());
  axi_.step(900);
  EXPECT_EQ(axi_.write_answers, std::deque<AxiResp>(10, AxiResp::kOkay));
  EXPECT_EQ(axi_.read_answers, (std::deque<AxiReadResult>{{AxiResp::kSlvErr, 0}}));
  axi_.write_answers.clear();
  axi_.read_answers.clear();
  expect_only_port_0_is_given_up();
}

TEST_P(AxiXbarHang, AHungWriteDoesNotBlockReadsAndEndsWithAnError) {
  writes_stuck_ = bit(0);
  axi_.post_write(kBase[0] + kWord, 1);
  for (int i = 0; i < 10; ++i) axi_.post_read(kBase[1] + kWord);
  axi_.step(100);
  EXPECT_TRUE(axi_.write_answers.empty());
  axi_.step(900);
  EXPECT_EQ(axi_.read_answers.size(), 10u);
  EXPECT_EQ(axi_.write_answers, (std::deque<AxiResp>{AxiResp::kSlvErr}));
  axi_.write_answers.clear();
  axi_.read_answers.clear();
  expect_only_port_0_is_given_up();
}

// All three ports hang one after the other, in every order, each in a read or in a write. The late answer of each comes
// before the next port hangs: it must not pass as the answer of a later access.
TEST_P(AxiXbarHang, PortsThatHangInAnyOrderStayGivenUp) {
  std::array<std::size_t, kSlaves> order{0, 1, 2};
  do {
    for (std::uint32_t by_read = 0; by_read < 1u << kSlaves; ++by_read) {
      SCOPED_TRACE(testing::Message() << "order " << order[0] << order[1] << order[2] << ", by a read " << by_read);
      restart();
      read_ones();
      std::uint32_t given_up = 0;
      for (const std::size_t port : order) {
        if (by_read & bit(port)) {
          reads_stuck_ = bit(port);
          EXPECT_EQ(axi_.read(kBase[port] + kWord), (AxiReadResult{AxiResp::kSlvErr, 0}));
        } else {
          writes_stuck_ = bit(port);
          EXPECT_EQ(axi_.write(kBase[port] + kWord, 1), AxiResp::kSlvErr);
        }
        writes_stuck_ = reads_stuck_ = 0;
        given_up |= bit(port);
        axi_.step(20);
        expect_given_up(given_up);
        if (HasFailure()) return;
      }
    }
  } while (std::ranges::next_permutation(order).found);
}

// The clock of a slave stops while it shows a response. This one belongs to its request, and to no later one, although
// the slave may accept that.
TEST_P(AxiXbarHang, AResponseThatNobodyAskedForIsAnErrorAndGivesThePortUp) {
  for (std::size_t port = 0; port < kSlaves; ++port) {
    SCOPED_TRACE(testing::Message() << "port " << port);
    restart();
    read_responses_stay_ = bit(port);
    EXPECT_EQ(axi_.write(kBase[port] + kWord, 7), AxiResp::kOkay);
    EXPECT_EQ(axi_.read(kBase[port] + kWord), (AxiReadResult{AxiResp::kOkay, 7}));
    EXPECT_EQ(axi_.read(kBase[port] + kWord), (AxiReadResult{AxiResp::kSlvErr, 0}));
    expect_given_up(bit(port));
    restart();
    write_responses_stay_ = bit(port);
    EXPECT_EQ(axi_.write(kBase[port] + kWord, 7), AxiResp::kOkay);
    EXPECT_EQ(axi_.write(kBase[port] + kWord, 8), AxiResp::kSlvErr);
    expect_given_up(bit(port));
  }
}

}  // namespace
}  // namespace armature::test
