// The other end of the controller's serial line: sends the items of the script and the bytes of a peer, receives what
// the controller sends.
//
// Without a peer an idle line has no events. A peer is polled every kPollCycles of simulated time. The host's time
// decides only which bytes have arrived by then.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "controller/base/units.hpp"
#include "cosim/serial/line_receiver.hpp"
#include "cosim/serial/line_sender.hpp"
#include "cosim/serial/serial_event.hpp"
#include "cosim/serial/serial_format.hpp"
#include "cosim/serial/serial_peer.hpp"
#include "cosim/serial/serial_script.hpp"

namespace armature::cosim {

class SerialLine {
 public:
  static constexpr Cycles kPollCycles{10'000};  // 200 us: at most some thousand host calls a second
  // While this many items wait for the line, no bytes are read from the peer.
  static constexpr std::size_t kMaxWaiting = 256;

  using Listener = std::function<void(const SerialEvent&)>;

  // `script` must be sorted by time. `peer` may be nullptr; it must outlive the line.
  SerialLine(const SerialFormat& format, std::vector<ScriptedItem> script, Listener listener,
             SerialPeer* peer = nullptr);

  [[nodiscard]] std::optional<Cycles> next_event() const;
  void advance(Cycles now);

  // The controller's transmit pin changes at `now`.
  void on_level(Cycles now, bool txd);

  // The controller's receive pin.
  [[nodiscard]] bool rxd() const { return sender_.level(); }

  // Number of characters, breaks and gaps to the controller that have not begun.
  [[nodiscard]] std::size_t unsent() const { return sender_.waiting() + script_.size() - next_in_script_; }

 private:
  void poll(Cycles now);
  void report();

  SerialFormat format_;
  LineSender sender_;
  LineReceiver receiver_;
  std::vector<ScriptedItem> script_;
  std::size_t next_in_script_ = 0;
  Listener listener_;
  SerialPeer* peer_;
  Cycles next_poll_{};
  std::vector<std::uint8_t> from_peer_;
  bool txd_ = true;
};

}  // namespace armature::cosim
