// The other end of the serial line for another program: a pseudo-terminal or a TCP port of this machine.
//
// The simulation never waits for the client. A buffer of kBufferBytes keeps what the controller sends until the client
// reads it. When the buffer is full, further bytes are lost and counted. Bytes from the client wait in the host until
// the line has space. None of them is lost: the client's writes block.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "cosim/serial/host/host_channel.hpp"
#include "cosim/serial/serial_peer.hpp"

namespace armature::cosim {

class HostPort final : public SerialPeer {
 public:
  static constexpr std::size_t kBufferBytes = 65'536;

  explicit HostPort(std::unique_ptr<HostChannel> channel) : channel_{std::move(channel)} {}

  void exchange(Cycles now, std::size_t room, std::vector<std::uint8_t>& in) override;
  void send(std::uint8_t byte) override;

  // Waits for the client to read the rest: until there has been no unread byte for kSettleMs, at most `longest_ms` of
  // host time. Returns the number of bytes that the client has not read, as far as the host reports it, plus the bytes
  // lost before.
  static constexpr int kFinishMs = 200;
  static constexpr int kSettleMs = 50;
  std::size_t finish(int longest_ms = kFinishMs);

  [[nodiscard]] std::string address() const { return channel_->address(); }
  [[nodiscard]] std::string token() const { return channel_->token(); }  // as of HostChannel
  [[nodiscard]] std::size_t lost() const { return lost_; }

 private:
  void flush();

  std::unique_ptr<HostChannel> channel_;
  std::vector<std::uint8_t> out_;  // not yet accepted by the host
  std::size_t lost_ = 0;
  bool sent_ = false;  // at least one byte
};

}  // namespace armature::cosim
