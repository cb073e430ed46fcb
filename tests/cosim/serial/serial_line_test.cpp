#include "cosim/serial/serial_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <string>
#include <vector>

namespace armature::cosim {
namespace {

using testing::ElementsAre;

constexpr SerialFormat kMillion{.baud = 1'000'000};  // 50 cycles a bit

class Peer final : public SerialPeer {
 public:
  void exchange(Cycles, std::size_t room, std::vector<std::uint8_t>& in) override {
    ++polls;
    rooms.push_back(room);
    for (; room > 0 && !waiting.empty(); --room, waiting.pop_front()) in.push_back(waiting.front());
  }
  void send(std::uint8_t byte) override { got += static_cast<char>(byte); }

  std::deque<std::uint8_t> waiting;
  std::string got;
  std::vector<std::size_t> rooms;
  int polls = 0;
};

class SerialLineTest : public testing::Test {
 protected:
  void make(const std::vector<SerialSendSpec>& sends, SerialPeer* peer = nullptr) {
    line_.emplace(
        kMillion, to_script(sends), [this](const SerialEvent& event) { events_.push_back(event); }, peer);
  }
  // With the controller's pins wired together.
  void loop_until(std::int64_t end) {
    for (auto next = line_->next_event(); next && next->value() < end; next = line_->next_event()) {
      ++steps_;
      line_->advance(*next);
      line_->on_level(*next, line_->rxd());
    }
  }
  [[nodiscard]] std::string text(SerialDirection direction) const {
    std::string all;
    for (const SerialEvent& event : events_) {
      if (event.direction == direction) all += static_cast<char>(event.byte);
    }
    return all;
  }

  std::optional<SerialLine> line_;
  std::vector<SerialEvent> events_;
  int steps_ = 0;
};

SerialSendSpec at(double at_s, const std::string& bytes) {
  SerialSendSpec send;
  send.at_s = at_s;
  send.bytes = bytes;
  return send;
}

TEST_F(SerialLineTest, WithoutScriptAndPeerNothingEverHappens) {
  make({});
  EXPECT_FALSE(line_->next_event());
  EXPECT_TRUE(line_->rxd());
}

TEST_F(SerialLineTest, SendsTheScriptInTheOrderOfItsTimesAndReceivesItBack) {
  make({at(0.001, "late"), at(0.0001, "early"), at(0.001, "r")});
  EXPECT_EQ(line_->next_event(), Cycles{5'000});
  loop_until(1'000'000);
  EXPECT_EQ(text(SerialDirection::kRx), "earlylater");
  EXPECT_EQ(text(SerialDirection::kTx), "earlylater");
  EXPECT_EQ(events_.front().at, Cycles{5'000});
  EXPECT_FALSE(line_->next_event()) << "an idle line costs nothing";
}

TEST_F(SerialLineTest, EventsComeInTheOrderOfTime) {
  make({at(0, "some text"), at(0.0001, "and more")});
  loop_until(1'000'000);
  for (std::size_t i = 1; i < events_.size(); ++i) EXPECT_LE(events_[i - 1].at, events_[i].at);
}

TEST_F(SerialLineTest, TellsTheDefectsThatItSends) {
  SerialSendSpec framing = at(0, "f"), pause = at(0, "");
  framing.fault = SerialFault::kFraming;
  framing.baud_error_percent = -1.5;
  pause.fault = SerialFault::kBreak;
  pause.break_s = 0.001;
  make({framing, pause});
  loop_until(1'000'000);
  ASSERT_EQ(events_.size(), 4u);
  EXPECT_TRUE(events_[0].framing_error);
  EXPECT_EQ(events_[0].baud_error_ppm, -15'000);
  EXPECT_TRUE(events_[1].framing_error);
  EXPECT_TRUE(events_[2].is_break);
  EXPECT_EQ(events_[2].break_duration, Cycles{50'000});
  EXPECT_TRUE(events_[3].is_break);
}

TEST_F(SerialLineTest, PollsItsPeerAtFixedCyclesOnly) {
  Peer peer;
  make({}, &peer);
  peer.waiting = {'h', 'i'};
  loop_until(10 * SerialLine::kPollCycles.value());
  EXPECT_EQ(peer.polls, 10);
  EXPECT_EQ(peer.got, "hi");
  EXPECT_EQ(events_.front().at, Cycles{0});
}

TEST_F(SerialLineTest, TakesFromThePeerOnlyWhatTheLineHasRoomFor) {
  Peer peer;
  make({}, &peer);
  peer.waiting.assign(1'000, 'x');
  loop_until(2'000'000);
  EXPECT_EQ(peer.rooms.front(), SerialLine::kMaxWaiting);
  for (const std::size_t room : peer.rooms) EXPECT_LE(room, SerialLine::kMaxWaiting);
  EXPECT_LT(peer.rooms[1], std::size_t{30}) << "one poll is the time of 20 characters";
  EXPECT_EQ(peer.got.size(), 1'000u) << "and nothing is lost";
}

TEST_F(SerialLineTest, ABreakIsNoByteForThePeer) {
  Peer peer;
  SerialSendSpec pause;
  pause.fault = SerialFault::kBreak;
  pause.break_s = 0.001;
  make({at(0, "a"), pause, at(0, "b")}, &peer);
  loop_until(1'000'000);
  EXPECT_EQ(peer.got, "ab");
}

}  // namespace
}  // namespace armature::cosim
