// Model of the block axi_uart16550: a 16550A with two FIFOs, modem lines, loopback and one interrupt. Written from
// rtl/REGISTERS.md, rtl/axi_uart16550/README.md and the behaviour of the PC16550D.
//
// A pin acts three edges later. The transmit pin, the modem outputs and the interrupt follow the registers one edge
// later.
#pragma once

#include <cstdint>

#include "cosim/model/block.hpp"
#include "cosim/model/pin_samples.hpp"
#include "cosim/model/uart/fifo.hpp"
#include "cosim/model/uart/modem_lines.hpp"
#include "cosim/model/uart/receive_status.hpp"
#include "cosim/model/uart/receiver.hpp"
#include "cosim/model/uart/transmitter.hpp"
#include "cosim/model/uart/uart_interrupt.hpp"

namespace armature::cosim::model {

// Levels before an edge.
struct UartInputs {
  bool rxd = true;
  bool cts_n = true, dsr_n = true, dcd_n = true, ri_n = true;

  friend bool operator==(const UartInputs&, const UartInputs&) = default;
};

class AxiUart16550 {
 public:
  Answer edge(Cycles at, const Strobes& access, const UartInputs& in);
  [[nodiscard]] Cycles wakes_at() const { return wakes_at_; }

  [[nodiscard]] bool txd() const { return txd_; }
  [[nodiscard]] bool dtr_n() const { return (modem_.outputs() & 1u) == 0; }
  [[nodiscard]] bool rts_n() const { return (modem_.outputs() & 2u) == 0; }
  [[nodiscard]] bool out1_n() const { return (modem_.outputs() & 4u) == 0; }
  [[nodiscard]] bool out2_n() const { return (modem_.outputs() & 8u) == 0; }
  [[nodiscard]] bool irq() const { return interrupt_.line(); }

  // The clock of everything but the synchroniser stands still from now on.
  void stop_gated_clock() {
    stopped_ = true;
    wakes_at_ = kNever;
  }

 private:
  // The line and CTS, DSR, RI, DCD from bit 0, active high.
  struct Pins {
    bool rxd = false;
    std::uint32_t modem = 0;

    friend bool operator==(const Pins&, const Pins&) = default;
  };
  // What the access of an edge means. A write that does not write byte 0 has no effect.
  struct Orders {
    bool push = false, pop = false;                                        // a write of THR, a read of RBR
    bool dll = false, dlm = false;                                         // writes of the divisor
    bool ier = false, fcr = false, lcr = false, mcr = false, scr = false;  // writes
    bool iir_read = false, lsr_read = false, msr_read = false;
    std::uint8_t data = 0;

    [[nodiscard]] bool flushes(bool fifo_on, std::uint32_t flush_bit) const {
      return fcr && ((data & 1u) != (fifo_on ? 1u : 0u) || ((data & 1u) != 0 && (data & flush_bit) != 0));
    }
  };

  [[nodiscard]] static Pins pins_of(const UartInputs& in);
  [[nodiscard]] Orders orders_of(const Strobes& access) const;
  [[nodiscard]] Answer read(std::uint32_t offset) const;
  [[nodiscard]] std::uint32_t lsr() const;
  [[nodiscard]] UartInterrupt::Levels levels() const;
  [[nodiscard]] const ReceivedCharacter* fresh() const { return received_.is_fresh() ? &received_.oldest() : nullptr; }
  [[nodiscard]] Receiver::Orders receiver_orders(bool transmitter_ends) const;
  [[nodiscard]] bool transmit_level() const;
  void set_registers(const Orders& orders);
  [[nodiscard]] bool has_divisor_latch() const;
  [[nodiscard]] bool loops() const;
  void find_wake(Cycles at, const Pins& pins);

  PinSamples<Pins, 2> pins_;
  Pins sampled_;  // one flop behind the synchroniser
  UartFifo<std::uint8_t> to_send_;
  UartFifo<ReceivedCharacter> received_;
  Transmitter transmitter_;
  Receiver receiver_;
  ReceiveStatus status_;
  ModemLines modem_;
  UartInterrupt interrupt_;
  bool txd_ = true;

  // Registers.
  std::int64_t divisor_ = 0;
  bool new_divisor_ = false;  // written at the latest edge
  bool fifo_on_ = false, dma_ = false;
  std::uint32_t trigger_ = 0;
  std::uint32_t lcr_ = 0, mcr_ = 0, scr_ = 0;

  Cycles wakes_at_ = Cycles{1};
  bool stopped_ = false;
};

}  // namespace armature::cosim::model
