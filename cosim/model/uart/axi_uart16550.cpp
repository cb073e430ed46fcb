#include "cosim/model/uart/axi_uart16550.hpp"

#include <algorithm>
#include <utility>

#include "controller/regs/axi_uart16550_regs.hpp"

namespace armature::cosim::model {
namespace uart_regs = armature::regs::axi_uart16550;
namespace {

constexpr std::uint32_t kUartMapEnd = 0x2000;
// Bits of FCR.
constexpr std::uint32_t kFifoOn = 1, kFlushReceived = 2, kFlushToSend = 4, kDma = 8;
constexpr std::uint32_t kTriggerLsb = 6;

}  // namespace

bool AxiUart16550::has_divisor_latch() const {
  return (lcr_ & uart_regs::kLcrDlabMask) != 0;
}

bool AxiUart16550::loops() const {
  return (mcr_ & uart_regs::kMcrLoopMask) != 0;
}

AxiUart16550::Pins AxiUart16550::pins_of(const UartInputs& in) {
  const auto bit = [](bool level_n, unsigned place) { return level_n ? 0u : 1u << place; };
  return {.rxd = in.rxd, .modem = bit(in.cts_n, 0) | bit(in.dsr_n, 1) | bit(in.ri_n, 2) | bit(in.dcd_n, 3)};
}

// Break and loopback change the pin only.
bool AxiUart16550::transmit_level() const {
  return loops() || (transmitter_.line() && (lcr_ & uart_regs::kLcrBrkMask) == 0);
}

UartInterrupt::Levels AxiUart16550::levels() const {
  return {.line_errors = status_.errors(fresh()) != 0,
          .fifo_on = fifo_on_,
          .trigger = trigger_,
          .received = received_.level(),
          .timeout = status_.timeout(),
          .modem_changes = modem_.changes() != 0};
}

// In loopback a character is reported when the transmitter has finished.
Receiver::Orders AxiUart16550::receiver_orders(bool transmitter_ends) const {
  return {.line = loops() ? transmitter_.line() : sampled_.rxd,
          .format = LineFormat::of(lcr_),
          .divisor = divisor_,
          .new_divisor = new_divisor_,
          .hold = loops() && transmitter_.is_busy() && !transmitter_ends};
}

Answer AxiUart16550::edge(Cycles at, const Strobes& access, const UartInputs& in) {
  if (stopped_) return {};
  Answer answer;
  if (access.read) answer = read(word_offset(access.raddr));
  if (access.write) answer.werr = word_offset(access.waddr) >= kUartMapEnd;
  const Orders orders = orders_of(access);

  // Everything follows from the state before the edge, so what is used by others changes last.
  const UartInterrupt::Levels levels = this->levels();
  const bool single = !fifo_on_;
  const bool thr_was_empty = to_send_.level() == 0;
  const bool txd = transmit_level();
  Receiver::Orders receiving = receiver_orders(false);

  const Transmitter::Events sent = transmitter_.edge(at, {.waits = to_send_.level() != 0,
                                                          .data = to_send_.oldest(),
                                                          .format = LineFormat::of(lcr_),
                                                          .divisor = divisor_,
                                                          .new_divisor = new_divisor_});
  receiving.hold = receiving.hold && !sent.ends;
  const bool arrives = receiver_.edge(at, receiving);

  const UartFifo<std::uint8_t>::Orders out{
      .flush = orders.flushes(fifo_on_, kFlushToSend), .push = orders.push, .pop = sent.takes, .entry = orders.data};
  const UartFifo<ReceivedCharacter>::Orders into{.flush = orders.flushes(fifo_on_, kFlushReceived),
                                                 .push = arrives,
                                                 .pop = orders.pop,
                                                 .entry = receiver_.character()};
  status_.edge(at, {.arrives = arrives ? &receiver_.character() : nullptr,
                    .fresh = fresh(),
                    .overrun = received_.events(into, single).overrun,
                    .pop = orders.pop,
                    .flush = into.flush,
                    .lsr_read = orders.lsr_read,
                    .fifo_on = fifo_on_,
                    .waiting = received_.level() != 0,
                    .format = LineFormat::of(lcr_),
                    .divisor = divisor_,
                    .new_divisor = new_divisor_});
  interrupt_.edge(levels, {.ier_written = orders.ier,
                           .ier = orders.data & 0xFu,
                           .iir_read = orders.iir_read,
                           .thr_written = orders.push,
                           .thr_is_empty = thr_was_empty,
                           .thr_empties = to_send_.events(out, single).empties});
  to_send_.edge(out, single);
  received_.edge(into, single);
  modem_.edge(at, mcr_, sampled_.modem, orders.msr_read);
  txd_ = txd;
  sampled_ = pins_.ago(2);
  pins_.sample(pins_of(in));
  set_registers(orders);
  find_wake(at, pins_of(in));
  return answer;
}

void AxiUart16550::find_wake(Cycles at, const Pins& pins) {
  const bool sends_at_once = to_send_.level() != 0 && divisor_ != 0 && !transmitter_.is_busy();
  const bool due = at <= ModemLines::kFills || !pins_.are_settled(pins) || sampled_ != pins_.ago(2) || new_divisor_ ||
                   sends_at_once || received_.is_fresh() || txd_ != transmit_level() ||
                   !modem_.is_settled(mcr_, sampled_.modem) ||
                   interrupt_.line() != (interrupt_.source(levels()) != UartInterrupt::kNone);
  wakes_at_ = due ? at + Cycles{1}
                  : std::min({transmitter_.wakes_at(divisor_), receiver_.wakes_at(at, receiver_orders(false)),
                              status_.wakes_at(fifo_on_, received_.level() != 0, divisor_)});
}

AxiUart16550::Orders AxiUart16550::orders_of(const Strobes& access) const {
  Orders orders;
  const bool latch = has_divisor_latch();
  if (access.read) {
    const std::uint32_t offset = word_offset(access.raddr);
    orders.pop = offset == uart_regs::kRbrOffset && !latch;
    orders.iir_read = offset == uart_regs::kIirOffset && !latch;
    orders.lsr_read = offset == uart_regs::kLsrOffset;
    orders.msr_read = offset == uart_regs::kMsrOffset;
  }
  if (!access.write || (access.wstrb & 1u) == 0) return orders;
  const std::uint32_t offset = word_offset(access.waddr);
  orders.data = static_cast<std::uint8_t>(access.wdata);
  orders.push = offset == uart_regs::kRbrOffset && !latch;
  orders.dll = offset == uart_regs::kRbrOffset && latch;
  orders.ier = offset == uart_regs::kIerOffset && !latch;
  orders.dlm = offset == uart_regs::kIerOffset && latch;
  orders.fcr = offset == uart_regs::kIirOffset;
  orders.lcr = offset == uart_regs::kLcrOffset;
  orders.mcr = offset == uart_regs::kMcrOffset;
  orders.scr = offset == uart_regs::kScrOffset;
  return orders;
}

void AxiUart16550::set_registers(const Orders& orders) {
  new_divisor_ = orders.dll || orders.dlm;
  if (orders.dll) divisor_ = (divisor_ & 0xFF00) | orders.data;
  if (orders.dlm) divisor_ = (divisor_ & 0x00FF) | std::int64_t{orders.data} << 8;
  if (orders.fcr) {
    fifo_on_ = (orders.data & kFifoOn) != 0;
    if (fifo_on_) {
      dma_ = (orders.data & kDma) != 0;
      trigger_ = orders.data >> kTriggerLsb;
    }
  }
  if (orders.lcr) lcr_ = orders.data;
  if (orders.mcr) mcr_ = orders.data & 0x1Fu;
  if (orders.scr) scr_ = orders.data;
}

std::uint32_t AxiUart16550::lsr() const {
  const bool thr_empty = to_send_.level() == 0;
  const auto bit = [](bool level, std::uint32_t mask) { return level ? mask : 0u; };
  return bit(received_.level() != 0, uart_regs::kLsrDrMask) | status_.errors(fresh()) |
         bit(thr_empty, uart_regs::kLsrThreMask) | bit(thr_empty && !transmitter_.is_busy(), uart_regs::kLsrTemtMask) |
         bit(fifo_on_ && status_.has_fifo_error(), uart_regs::kLsrFifoErrorMask);
}

Answer AxiUart16550::read(std::uint32_t offset) const {
  const bool latch = has_divisor_latch();
  switch (offset) {
    case uart_regs::kRbrOffset:
      if (latch) return {.rdata = static_cast<std::uint32_t>(divisor_ & 0xFF)};
      return {.rdata = received_.level() != 0 ? received_.oldest().data : 0u};
    case uart_regs::kIerOffset:
      return {.rdata = latch ? static_cast<std::uint32_t>(divisor_ >> 8) : interrupt_.ier()};
    case uart_regs::kIirOffset:
      if (latch) return {.rdata = trigger_ << kTriggerLsb | (dma_ ? kDma : 0u) | (fifo_on_ ? kFifoOn : 0u)};
      return {.rdata = (fifo_on_ ? 0xC0u : 0u) | interrupt_.source(levels())};
    case uart_regs::kLcrOffset:
      return {.rdata = lcr_};
    case uart_regs::kMcrOffset:
      return {.rdata = mcr_};
    case uart_regs::kLsrOffset:
      return {.rdata = lsr()};
    case uart_regs::kMsrOffset:
      return {.rdata = modem_.msr()};
    case uart_regs::kScrOffset:
      return {.rdata = scr_};
    default:
      return offset >= kUartMapEnd ? kUnmappedRead : Answer{};
  }
}

}  // namespace armature::cosim::model
