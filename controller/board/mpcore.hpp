// Registers of the Cortex-A9 MPCore in the Zynq-7020: interrupt controller and global timer. Both cores see them at the
// same address. Source: UG585 (Zynq-7000 TRM) appendix B.24 "mpcore", ARM DDI 0407I.
//
// The firmware and its simulator (cosim/iss) share this list.
#pragma once

#include <cstdint>

namespace armature::board::mpcore {

inline constexpr std::uint32_t kBase = 0xF8F0'0000;
inline constexpr std::uint32_t kSize = 0x2000;

// In the on-chip memory, where the boot ROM of core 1 looks for the address to continue at (UG585 section 6.1.10).
inline constexpr std::uint32_t kCore1Start = 0xFFFF'FFF0;

// ---- snoop control unit: coherency of the two L1 caches
inline constexpr std::uint32_t kScuControl = 0x000;  // bit 0: on

// ---- interrupt controller, interface of the core that accesses it
inline constexpr std::uint32_t kIccControl = 0x100;      // ICCICR, bit 0: on
inline constexpr std::uint32_t kIccPriority = 0x104;     // ICCPMR: priorities below this are signalled
inline constexpr std::uint32_t kIccAcknowledge = 0x10C;  // ICCIAR: the interrupt that is taken
inline constexpr std::uint32_t kIccEnd = 0x110;          // ICCEOIR: what ICCIAR returned

// ---- global timer: 64 bits that count half the CPU clock
inline constexpr std::uint32_t kTimerLow = 0x200;
inline constexpr std::uint32_t kTimerHigh = 0x204;
inline constexpr std::uint32_t kTimerControl = 0x208;  // bit 0: on

// ---- interrupt controller, distributor; one bit for each interrupt
inline constexpr std::uint32_t kIcdControl = 0x1000;   // ICDDCR, bit 0: on
inline constexpr std::uint32_t kIcdEnable = 0x1100;    // ICDISER0..2: writing 1 enables
inline constexpr std::uint32_t kIcdDisable = 0x1180;   // ICDICER0..2: writing 1 disables
inline constexpr std::uint32_t kIcdPending = 0x1200;   // ICDISPR0..2; ICDISPR0 is that of the core
inline constexpr std::uint32_t kIcdTargets = 0x1800;   // ICDIPTR: a byte for each interrupt, bit n: core n
inline constexpr std::uint32_t kIcdSoftware = 0x1F00;  // ICDSGIR: sends a software interrupt

// ICDSGIR: to the other core, interrupt 0.
inline constexpr std::uint32_t kToTheOtherCore = 1u << 24;

// ---- interrupts
inline constexpr std::uint32_t kEventId = 0;        // software interrupt of the other core or of the host
inline constexpr std::uint32_t kFirstLogicId = 61;  // irq_o[0] of the logic, IRQF2P[0]; the next ones follow
inline constexpr std::uint32_t kLogicWord = kFirstLogicId / 32;      // register of ICDISER, ICDICER and ICDISPR
inline constexpr std::uint32_t kFirstLogicBit = kFirstLogicId % 32;  // in that register

// Half the CPU clock of 666.667 MHz, against the 50 MHz of the logic: 20 to 3.
inline constexpr std::uint64_t kTimerTicks = 20;
inline constexpr std::uint64_t kLogicCycles = 3;

}  // namespace armature::board::mpcore
