// The teach pendant of a live page at the simulated serial line: what the page presses becomes frames, which the line
// sends bit by bit. Its time is simulated time, so it behaves the same however fast the simulation runs.
//
// The dead-man: without an operator it stops the arm, and stops it again while it moves.
#pragma once

#include <cstdint>
#include <vector>

#include "cosim/pendant/operator_link.hpp"
#include "cosim/serial/serial_peer.hpp"

namespace armature::cosim {

class LivePendant final : public SerialPeer {
 public:
  using Time = OperatorLink::Time;
  static constexpr Time kJogLasts{150'000};        // after each press; the page repeats it every 50 ms
  static constexpr Time kStopEvery{100'000};       // without an operator
  static constexpr Time kControllerBegins{2'000};  // by then it has configured its UART

  // SerialPeer
  void exchange(Cycles now, std::size_t room, std::vector<std::uint8_t>& in) override;
  void send(std::uint8_t byte) override { link_.receive({&byte, 1}); }

  // The page is there and alive, or not. At first nobody is there.
  void set_operator(bool there);
  [[nodiscard]] bool has_operator() const { return operator_; }

  // Without an operator these do nothing. `system`: coordinates of the jog; the pendant selects them first.
  void jog(pendant::System system, std::uint8_t axis, std::int32_t velocity);
  // After the operator was away a jog begins only when the key was released.
  void release_jog();
  bool press(const pendant::Frame& command) { return operator_ && link_.press(command); }

  // For everything else: press_estop(), download(), what the controller reports.
  [[nodiscard]] OperatorLink& link() { return link_; }
  [[nodiscard]] const OperatorLink& link() const { return link_; }

 private:
  void watch_operator();

  OperatorLink link_{1};
  std::vector<std::uint8_t> waiting_;
  Time now_{};
  bool operator_ = false;
  bool must_release_ = true;
  Time next_stop_{};
  Time next_system_{};
};

}  // namespace armature::cosim
