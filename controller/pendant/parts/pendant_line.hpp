// The serial line of the pendant: bytes from and to the UART, the emergency stop, and frames.
//
// The interrupt reads the UART's buffer. It stops the pulses itself when it finds an emergency stop. Frames are looked
// for later, outside the interrupt.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/base/spsc_queue.hpp"
#include "controller/drivers/axi_uart16550.hpp"
#include "controller/hal/interrupt_handler.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/pendant/parts/estop_detector.hpp"
#include "controller/pendant/protocol/frame.hpp"
#include "controller/pendant/protocol/frame_receiver.hpp"

namespace armature::pendant {

class PendantLine final : public InterruptHandler {
 public:
  static constexpr std::int32_t kBaud = 115'200;

  // `paper_logic`: the logic is that of Vo 2021.
  explicit PendantLine(bool paper_logic) noexcept : paper_logic_{paper_logic} {}

  // InterruptHandler of the UART.
  [[nodiscard]] bool enabled() const noexcept override { return uart_.has_value(); }
  void on_interrupt(RegisterBus& bus) noexcept override;

  [[nodiscard]] bool started() const noexcept { return uart_.has_value(); }
  void start(RegisterBus& bus) noexcept;
  // Does what the interrupt does, if there is anything to do: for software that runs for long between interrupts.
  void poll(RegisterBus& bus) noexcept;

  // True once for each emergency stop.
  [[nodiscard]] bool take_estop() noexcept;
  // The next frame that was received.
  [[nodiscard]] std::optional<FrameBytes> next_frame() noexcept;

  // Room for so many frames to send.
  [[nodiscard]] bool has_room(std::size_t frames) const noexcept { return out_.has_room(frames * kFrameBytes); }
  // A frame without room is lost; the pendant asks again.
  void send(const FrameBytes& frame) noexcept;
  // Gives the UART what it takes.
  void flush() noexcept;

 private:
  static constexpr std::size_t kReceivedBytes = 128, kSentBytes = 64 * kFrameBytes;
  // Beside the bytes in the queue: the frame under way is damaged or ended.
  static constexpr std::uint16_t kGap = 0x100;

  void read(RegisterBus& bus, bool silent) noexcept;
  void stop_pulses(RegisterBus& bus) noexcept;

  bool paper_logic_;
  std::optional<AxiUart16550> uart_;
  EstopDetector detector_;
  bool estop_ = false;
  SpscQueue<std::uint16_t, kReceivedBytes> in_;
  FrameReceiver receiver_{End::kController};
  SpscQueue<std::uint8_t, kSentBytes> out_;
};

}  // namespace armature::pendant
