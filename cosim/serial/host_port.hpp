// The far end of the serial line as another program sees it: a pseudo-terminal or a TCP port of this machine.
//
// The simulation never waits for the client. What the controller sends is kept until the client takes it, up to
// kBufferBytes; a byte that finds them full is lost and counted. What the client sends waits with the host until the
// line has room: nothing is lost there, the client's writes block.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "cosim/serial/host_channel.hpp"
#include "cosim/serial/serial_peer.hpp"

namespace armature::cosim {

class HostPort final : public SerialPeer {
 public:
  static constexpr std::size_t kBufferBytes = 65'536;

  explicit HostPort(std::unique_ptr<HostChannel> channel) : channel_{std::move(channel)} {}

  void exchange(std::size_t room, std::vector<std::uint8_t>& in) override;
  void send(std::uint8_t byte) override;

  // Waits for the client to take what is left: until there has been none for kSettleMs, at most `longest_ms` of the
  // host's time. Returns how many bytes it has not taken, those lost before included, as far as the host tells.
  static constexpr int kFinishMs = 200;
  static constexpr int kSettleMs = 50;
  std::size_t finish(int longest_ms = kFinishMs);

  [[nodiscard]] std::string place() const { return channel_->place(); }
  [[nodiscard]] std::size_t lost() const { return lost_; }

 private:
  void flush();

  std::unique_ptr<HostChannel> channel_;
  std::vector<std::uint8_t> out_;  // not yet taken by the host
  std::size_t lost_ = 0;
  bool sent_ = false;  // anything at all
};

}  // namespace armature::cosim
