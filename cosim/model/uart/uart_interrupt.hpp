// The interrupt of the UART: IER, the source with the highest priority (IIR bits 3:0), and the line, which follows the
// sources one edge later.
//
// "THR empty" is latched: the transmit FIFO has become empty, or its enable was set while it was empty. A write of THR
// and a read of IIR that returns it end it. The other sources are levels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/regs/axi_uart16550_regs.hpp"

namespace armature::cosim::model {

class UartInterrupt {
 public:
  // Codes of IIR.
  static constexpr std::uint32_t kLineStatus = 0x6, kData = 0x4, kTimeout = 0xC, kThrEmpty = 0x2, kModem = 0x0,
                                 kNone = 0x1;

  struct Levels {
    bool line_errors = false;
    bool fifo_on = false;
    std::uint32_t trigger = 0;  // FCR 7:6
    std::size_t received = 0;   // characters that wait
    bool timeout = false;
    bool modem_changes = false;
  };
  // At an edge.
  struct Orders {
    bool ier_written = false;
    std::uint32_t ier = 0;
    bool iir_read = false;
    bool thr_written = false;
    bool thr_is_empty = false, thr_empties = false;
  };

  [[nodiscard]] std::uint32_t source(const Levels& levels) const {
    namespace regs = armature::regs::axi_uart16550;
    static constexpr std::array<std::size_t, 4> kTriggers{1, 4, 8, 14};
    const std::size_t enough = levels.fifo_on ? kTriggers[levels.trigger] : 1;
    const auto enables = [this](std::uint32_t bit) { return (ier_ & bit) != 0; };
    if (enables(regs::kIerLineStatusMask) && levels.line_errors) return kLineStatus;
    if (enables(regs::kIerRxDataMask) && levels.received >= enough) return kData;
    if (enables(regs::kIerRxDataMask) && levels.timeout) return kTimeout;
    if (enables(regs::kIerTxEmptyMask) && thr_empty_) return kThrEmpty;
    if (enables(regs::kIerModemMask) && levels.modem_changes) return kModem;
    return kNone;
  }

  // `levels`: before the edge.
  void edge(const Levels& levels, const Orders& orders) {
    namespace regs = armature::regs::axi_uart16550;
    const std::uint32_t now = source(levels);
    line_ = now != kNone;
    const std::uint32_t set = orders.ier_written ? orders.ier & ~ier_ : 0u;
    const bool sets = orders.thr_empties || ((set & regs::kIerTxEmptyMask) != 0 && orders.thr_is_empty);
    const bool ends = orders.thr_written || (orders.iir_read && now == kThrEmpty);
    if (sets || ends) thr_empty_ = sets;
    if (orders.ier_written) ier_ = orders.ier;
  }

  [[nodiscard]] std::uint32_t ier() const { return ier_; }
  [[nodiscard]] bool line() const { return line_; }

 private:
  std::uint32_t ier_ = 0;
  bool thr_empty_ = false;
  bool line_ = false;
};

}  // namespace armature::cosim::model
