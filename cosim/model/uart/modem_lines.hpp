// The modem lines of the UART: MSR, and the outputs of MCR. Loopback connects the outputs to the inputs; the pins idle.
#pragma once

#include <cstdint>

#include "controller/regs/axi_uart16550_regs.hpp"
#include "cosim/model/block.hpp"

namespace armature::cosim::model {

class ModemLines {
 public:
  // The edge `at`. `lines`: CTS, DSR, RI, DCD from bit 0, active high, behind the synchroniser.
  void edge(Cycles at, std::uint32_t mcr, std::uint32_t lines, bool msr_read) {
    const std::uint32_t now = seen(mcr, lines);
    if (at > kFills) changes_ = (msr_read ? 0u : changes_) | changed(now);
    lines_ = now;
    outputs_ = driven(mcr);
  }

  [[nodiscard]] bool is_settled(std::uint32_t mcr, std::uint32_t lines) const {
    return lines_ == seen(mcr, lines) && outputs_ == driven(mcr);
  }

  [[nodiscard]] std::uint32_t msr() const { return lines_ << 4 | changes_; }
  [[nodiscard]] std::uint32_t changes() const { return changes_; }
  // Active high: DTR, RTS, OUT1, OUT2 from bit 0.
  [[nodiscard]] std::uint32_t outputs() const { return outputs_; }

  static constexpr Cycles kFills{4};  // edges after reset before a level of the pins comes here

 private:
  static constexpr std::uint32_t kRi = 1u << 2;

  [[nodiscard]] static bool loops(std::uint32_t mcr) {
    return (mcr & armature::regs::axi_uart16550::kMcrLoopMask) != 0;
  }
  [[nodiscard]] static std::uint32_t driven(std::uint32_t mcr) { return loops(mcr) ? 0u : mcr & 0xFu; }
  // In loopback RTS is CTS, DTR is DSR, OUT1 is RI and OUT2 is DCD.
  [[nodiscard]] static std::uint32_t seen(std::uint32_t mcr, std::uint32_t lines) {
    return loops(mcr) ? (mcr & 0xCu) | (mcr & 1u) << 1 | (mcr & 2u) >> 1 : lines;
  }
  // RI is reported at its end, the other lines at every change.
  [[nodiscard]] std::uint32_t changed(std::uint32_t now) const { return (now ^ lines_) & (~kRi | lines_); }

  std::uint32_t lines_ = 0, changes_ = 0;
  std::uint32_t outputs_ = 0;
};

}  // namespace armature::cosim::model
