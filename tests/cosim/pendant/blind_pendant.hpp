// A pendant that sends what it was given at its times, and does not wait for replies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "controller/base/timebase.hpp"
#include "controller/base/units.hpp"
#include "controller/pendant/protocol/command_link.hpp"
#include "controller/pendant/protocol/frame.hpp"
#include "cosim/serial/serial_peer.hpp"

namespace armature::cosim::test {

inline constexpr Cycles kMs{kClkFreqHz / 1'000};
[[nodiscard]] constexpr Cycles ms(std::int64_t count) {
  return Cycles{count * kMs.value()};
}

class BlindPendant final : public SerialPeer {
 public:
  // Begins a session, and switches the drives on: they are on at 20 ms.
  BlindPendant() {
    at(ms(1), pendant::Frame{.opcode = pendant::Opcode::kHeartbeat, .parameter = pendant::kBeginSession, .payload = 1});
    at(ms(8), pendant::Frame{.opcode = pendant::Opcode::kServo, .parameter = 1});
  }

  // In the order of time.
  void at(Cycles when, pendant::Frame frame) {
    frame.sequence = sequence_;
    sequence_ = pendant::after(sequence_);
    const pendant::FrameBytes bytes = encode(frame);
    at(when, std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
  }
  void at(Cycles when, std::vector<std::uint8_t> bytes) { waiting_.emplace_back(when, std::move(bytes)); }

  void exchange(Cycles now, std::size_t, std::vector<std::uint8_t>& in) override {
    while (!waiting_.empty() && waiting_.front().first <= now) {
      in.insert(in.end(), waiting_.front().second.begin(), waiting_.front().second.end());
      waiting_.pop_front();
    }
  }
  void send(std::uint8_t byte) override { got.push_back(byte); }

  std::vector<std::uint8_t> got;

 private:
  std::uint8_t sequence_ = 0;
  std::deque<std::pair<Cycles, std::vector<std::uint8_t>>> waiting_;
};

}  // namespace armature::cosim::test
