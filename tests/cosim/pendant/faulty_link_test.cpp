// Both ends of the protocol on a line with faults: commands and programs arrive, and nothing is executed twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "controller/pendant/protocol/bulk_receiver.hpp"
#include "controller/pendant/protocol/command_link.hpp"
#include "controller/pendant/protocol/frame_receiver.hpp"
#include "cosim/pendant/bulk_sender.hpp"
#include "cosim/pendant/command_sender.hpp"
#include "tests/controller/support/draws.hpp"
#include "tests/cosim/pendant/faulty_line.hpp"

namespace armature::cosim {
namespace {

using armature::test::draws;
using pendant::decode;
using pendant::decode_bulk;
using pendant::encode;
using pendant::End;
using pendant::Frame;
using pendant::FrameBytes;
using pendant::Kind;
using pendant::kind_of;
using pendant::Opcode;
using pendant::Status;
using test::FaultyLine;
using test::kByteTime;
using test::kCharacterTimeout;
using test::Time;

// A receiver with the time-out of a UART.
class TimedReceiver {
 public:
  explicit TimedReceiver(End end) : receiver_{end} {}

  std::optional<FrameBytes> step(std::optional<std::uint8_t> byte) {
    if (byte) {
      silent_ = Time{0};
      return receiver_.push(*byte);
    }
    silent_ += kByteTime;
    if (silent_ > kCharacterTimeout) receiver_.discard();
    return std::nullopt;
  }

 private:
  pendant::FrameReceiver receiver_;
  Time silent_{};
};

// The controller's end: executes what it is told after a delay, and keeps a record.
class Controller {
 public:
  Controller(FaultyLine& from, FaultyLine& to, std::span<char> store, std::uint64_t seed)
      : from_{from}, to_{to}, bulk_{store}, random_{seed} {}

  void step() {
    if (delay_ > 0 && --delay_ == 0) answer();
    const std::optional<FrameBytes> bytes = receiver_.step(from_.step());
    if (!bytes) return;
    if (kind_of(*bytes) == Kind::kBulk) {
      if (const auto reply = bulk_.push(decode_bulk(*bytes))) to_.send(encode(*reply));
      return;
    }
    const Frame command = decode(*bytes);
    const pendant::CommandLink::Decision decision = link_.on_command(command);
    if (decision.reply) to_.send(encode(*decision.reply));
    if (!decision.execute) return;
    executed.push_back(command.payload);
    if (command.opcode == Opcode::kProgramBegin) static_cast<void>(bulk_.begin(command.payload));
    delay_ = 1 + static_cast<int>(random_.below(300));  // up to 26 ms, longer than the repetition of a command
  }

  [[nodiscard]] const pendant::BulkReceiver& bulk() const { return bulk_; }

  std::vector<std::int32_t> executed;

 private:
  void answer() {
    if (const auto reply = link_.answer(Status::kOk)) to_.send(encode(*reply));
  }

  FaultyLine& from_;
  FaultyLine& to_;
  TimedReceiver receiver_{End::kController};
  pendant::CommandLink link_;
  pendant::BulkReceiver bulk_;
  armature::test::SplitMix random_;
  int delay_ = 0;
};

struct Outcome {
  std::vector<std::int32_t> executed;
  std::vector<std::int32_t> answered;  // the commands whose reply came
  int lost = 0;                        // commands without a reply
  std::int64_t repeated = 0;
};

// A pendant that sends commands with the payloads 1, 2, 3 ..., and begins a session after it has lost one.
Outcome exchange(std::uint64_t seed, std::uint32_t one_in, int commands) {
  FaultyLine down{seed, one_in}, up{seed + 1, one_in};
  std::vector<char> store(16);
  Controller controller{down, up, store, seed + 2};
  CommandSender sender;
  TimedReceiver receiver{End::kPendant};
  Outcome outcome;
  std::int32_t next = 1, session = 0, present = 0;
  bool in_session = false;
  for (Time now{}; next <= commands || !sender.idle(); now += kByteTime) {
    if (sender.idle()) {
      if (sender.lost()) {
        outcome.lost += present > 0;
        in_session = false;
      }
      Frame command{.opcode = Opcode::kJogIncrement, .payload = present = next};
      if (in_session) {
        ++next;
      } else {
        command = {.opcode = Opcode::kHeartbeat, .parameter = pendant::kBeginSession, .payload = ++session};
        present = 0;
      }
      down.send(sender.send(command, now));
    } else if (const auto again = sender.poll(now)) {
      down.send(*again);
    }
    controller.step();
    const std::optional<FrameBytes> bytes = receiver.step(up.step());
    if (!bytes) continue;
    const Frame reply = decode(*bytes);
    if (!sender.on_reply(reply)) continue;
    if (present == 0) {
      in_session = reply.status() == Status::kOk;
    } else if (reply.status() == Status::kOk) {
      outcome.answered.push_back(present);
    }
  }
  outcome.executed = controller.executed;
  outcome.repeated = sender.repeated();
  return outcome;
}

TEST(PendantLink, WithoutFaultsEveryCommandIsExecutedAndAnsweredOnce) {
  const Outcome outcome = exchange(1, 0, 200);
  std::vector<std::int32_t> all(200);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::int32_t>(i + 1);
  EXPECT_EQ(outcome.executed, all);
  EXPECT_EQ(outcome.answered, all);
  EXPECT_EQ(outcome.lost, 0);
}

// Each of the five kinds of fault hits one of so many bytes. At 30, more than every second frame is damaged.
//
// An eight-bit CRC misses one of 256 errors that damage more than three bits. So a few of the commands that were
// executed are not those that were sent: more than those could only come from an error of the link.
TEST(PendantLink, OnAFaultyLineNoCommandIsExecutedTwiceAndAnsweredOnesAreExecuted) {
  constexpr std::int32_t kCommands = 250;
  for (const std::uint32_t one_in : {3'000u, 1'000u, 300u, 100u, 30u}) {
    std::int64_t damaged = 0, executed = 0, repeated = 0, lost = 0;
    for (int draw = 0; draw < draws(40); ++draw) {
      const auto seed = static_cast<std::uint64_t>(0x15C0'0000 + static_cast<int>(one_in) * 1'000 + draw);
      Outcome outcome = exchange(seed, one_in, kCommands);
      executed += std::ssize(outcome.executed);
      repeated += outcome.repeated;
      lost += outcome.lost;
      std::erase_if(outcome.executed, [](std::int32_t payload) { return payload < 1 || payload > kCommands; });
      ASSERT_EQ(std::ranges::adjacent_find(outcome.executed, std::ranges::greater_equal{}), outcome.executed.end())
          << "executed twice or in another order, seed " << seed;
      damaged += std::ranges::count_if(outcome.answered, [&](std::int32_t payload) {
        return !std::ranges::binary_search(outcome.executed, payload);
      });
    }
    EXPECT_GT(repeated, 0) << "the faults had no effect, one in " << one_in;
    EXPECT_LE(damaged, one_in < 300 ? 1 + executed / 1'000 : 0) << "of " << executed << ", one in " << one_in;
    RecordProperty("one_in_" + std::to_string(one_in), "executed " + std::to_string(executed) + ", repeated " +
                                                           std::to_string(repeated) + ", lost " + std::to_string(lost) +
                                                           ", damaged " + std::to_string(damaged));
  }
}

std::string random_text(armature::test::SplitMix& random, std::size_t size) {
  std::string text(size, ' ');
  std::ranges::generate(text, [&] { return static_cast<char>(random.below(128)); });
  return text;
}

struct Transfer {
  bool complete = false;
  bool equal = false;
  bool check = false;
  Time took{};
  std::int64_t repeated = 0;
};

Transfer transfer(std::uint64_t seed, std::uint32_t one_in, std::size_t size) {
  armature::test::SplitMix random{seed};
  const std::string text = random_text(random, size);
  FaultyLine down{seed + 1, one_in}, up{seed + 2, one_in};
  std::vector<char> store(size);
  pendant::BulkReceiver bulk{store};
  EXPECT_TRUE(bulk.begin(static_cast<std::int32_t>(size)));
  BulkSender sender{text};
  TimedReceiver at_controller{End::kController}, at_pendant{End::kPendant};
  Transfer result;
  constexpr Time kLongest{20'000'000};
  while (!sender.complete() && result.took < kLongest) {
    result.took += kByteTime;
    while (const auto bytes = sender.poll(result.took)) down.send(*bytes);
    if (const auto bytes = at_controller.step(down.step()); bytes && kind_of(*bytes) == Kind::kBulk) {
      if (const auto reply = bulk.push(decode_bulk(*bytes))) up.send(encode(*reply));
    }
    if (const auto bytes = at_pendant.step(up.step())) sender.on_reply(decode(*bytes), result.took);
  }
  result.complete = sender.complete() && bulk.complete();
  result.equal = std::string(bulk.text().begin(), bulk.text().end()) == text;
  result.check = bulk.check() == sender.check();
  result.repeated = sender.repeated();
  return result;
}

TEST(PendantBulk, ALineWithoutFaultsCarriesMoreThanEightKilobytesPerSecond) {
  const Transfer result = transfer(1, 0, 20'000);
  EXPECT_TRUE(result.complete && result.equal && result.check);
  EXPECT_EQ(result.repeated, 0);
  EXPECT_LT(result.took, Time{20'000'000 / 8});
}

// A wrong text can only come from errors that the CRC of a frame misses. That of the whole text finds them.
TEST(PendantBulk, OnAFaultyLineTheTextArrivesOrTheCheckValueSaysThatItIsWrong) {
  for (const std::uint32_t one_in : {3'000u, 1'000u, 300u, 100u}) {
    int wrong = 0;
    std::int64_t repeated = 0;
    for (int draw = 0; draw < draws(30); ++draw) {
      const auto seed = static_cast<std::uint64_t>(0x15B0'0000 + static_cast<int>(one_in) * 1'000 + draw);
      const Transfer result = transfer(seed, one_in, 3'000);
      ASSERT_TRUE(result.complete) << "seed " << seed;
      ASSERT_EQ(result.equal, result.check) << "seed " << seed;
      wrong += !result.equal;
      repeated += result.repeated;
    }
    EXPECT_LE(wrong, one_in < 300 ? 15 : 3) << "one in " << one_in;
    RecordProperty("one_in_" + std::to_string(one_in),
                   "repeated " + std::to_string(repeated) + ", wrong " + std::to_string(wrong));
  }
}

}  // namespace
}  // namespace armature::cosim
