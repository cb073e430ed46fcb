#include "cosim/serial/host/host_port.hpp"

#include <chrono>
#include <thread>

namespace armature::cosim {

void HostPort::exchange(Cycles, std::size_t room, std::vector<std::uint8_t>& in) {
  flush();
  const std::size_t before = in.size();
  in.resize(before + room);
  const std::size_t count = room == 0 ? 0 : channel_->read(std::span{in}.subspan(before));
  in.resize(before + count);
}

void HostPort::send(std::uint8_t byte) {
  sent_ = true;
  if (out_.size() >= kBufferBytes) {
    ++lost_;
    return;
  }
  out_.push_back(byte);
}

std::size_t HostPort::finish(int longest_ms) {
  // The host transfers bytes in the background, so the number of unread bytes is reliable only after some time.
  int settled_ms = 0;
  for (int ms = 0; sent_ && ms < longest_ms && settled_ms < kSettleMs; ++ms) {
    flush();
    settled_ms = out_.empty() && channel_->unread() == 0 ? settled_ms + 1 : 0;
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  }
  return lost_ + out_.size() + channel_->unread();
}

void HostPort::flush() {
  if (out_.empty()) return;
  const std::size_t count = channel_->write(out_);
  out_.erase(out_.begin(), out_.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace armature::cosim
