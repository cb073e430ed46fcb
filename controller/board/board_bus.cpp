#include "controller/board/board_bus.hpp"

#include "controller/board/mpcore.hpp"

// Called for each piece of work that is charged. It does nothing: a simulator finds it by its name and charges its
// cores. `work`: of RegisterBus::Work.
extern "C" [[gnu::noinline]] void armature_charge(std::uint32_t work, std::uint32_t times) {
  asm volatile("" ::"r"(work), "r"(times));
}

namespace armature::board {
namespace {

namespace m = mpcore;

volatile std::uint32_t& at(std::uint32_t address) noexcept {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}
volatile std::uint32_t& reg(std::uint32_t offset) noexcept {
  return at(m::kBase + offset);
}

constexpr std::uint32_t bits(Interrupts lines) noexcept {
  return static_cast<std::uint32_t>(lines);
}

// The lines of the logic as bits of their register in the distributor: irq_o[n] is bit n of Interrupts.
constexpr std::uint32_t kLogicLines = bits(Interrupts::kTimer) | bits(Interrupts::kUart) | bits(Interrupts::kGpio);
constexpr std::uint32_t logic_bits(Interrupts lines) noexcept {
  return (bits(lines) & kLogicLines) << m::kFirstLogicBit;
}

constexpr std::uint32_t kEventBit = 1u << m::kEventId;

// The interrupts whose pending bits are set.
Interrupts pending() noexcept {
  const std::uint32_t logic = reg(m::kIcdPending + 4 * m::kLogicWord) >> m::kFirstLogicBit & kLogicLines;
  const bool event = (reg(m::kIcdPending) & kEventBit) != 0;
  return static_cast<Interrupts>(logic) | (event ? Interrupts::kEvent : Interrupts::kNone);
}

void acknowledge_event() noexcept {
  // Of all that is pending it has the lowest number, so it is first.
  reg(m::kIccEnd) = reg(m::kIccAcknowledge);
}

}  // namespace

void BoardBus::start_mpcore() noexcept {
  reg(m::kScuControl) = 1;
  reg(m::kTimerControl) = 0;
  reg(m::kTimerLow) = 0;
  reg(m::kTimerHigh) = 0;
  reg(m::kTimerControl) = 1;
  reg(m::kIcdControl) = 1;
}

BoardBus::BoardBus(int core, Interrupts lines) noexcept {
  for (std::uint32_t id = m::kFirstLogicId, left = bits(lines) & kLogicLines; left != 0; ++id, left >>= 1) {
    if ((left & 1) == 0) continue;
    volatile auto* const targets = reinterpret_cast<volatile std::uint8_t*>(m::kBase + m::kIcdTargets);
    targets[id] = static_cast<std::uint8_t>(1 << core);
  }
  reg(m::kIccPriority) = 0xFF;
  reg(m::kIccControl) = 1;
}

std::uint32_t BoardBus::read32(RegAddr addr) noexcept {
  return at(addr.value);
}

void BoardBus::write32(RegAddr addr, std::uint32_t value) noexcept {
  at(addr.value) = value;
}

// Software interrupts are always enabled.
void BoardBus::enable(Interrupts mask) noexcept {
  const std::uint32_t wanted = logic_bits(mask), now = logic_bits(enabled_);
  if ((wanted & ~now) != 0) reg(m::kIcdEnable + 4 * m::kLogicWord) = wanted & ~now;
  if ((now & ~wanted) != 0) reg(m::kIcdDisable + 4 * m::kLogicWord) = now & ~wanted;
  enabled_ = mask;
}

Interrupts BoardBus::wait_for_interrupt(Interrupts mask) noexcept {
  enable(mask);
  for (;;) {
    asm volatile("dsb\n\twfi" ::: "memory");
    const Interrupts lines = pending() & mask;
    if ((lines & Interrupts::kEvent) != Interrupts::kNone) acknowledge_event();
    if (lines != Interrupts::kNone) return lines;
  }
}

void BoardBus::send_event() noexcept {
  asm volatile("dsb" ::: "memory");  // what this core has written is seen before
  reg(m::kIcdSoftware) = m::kToTheOtherCore | m::kEventId;
}

Cycles BoardBus::now() noexcept {
  for (std::uint32_t high = reg(m::kTimerHigh);;) {
    const std::uint32_t low = reg(m::kTimerLow), again = reg(m::kTimerHigh);
    if (again == high) {
      const std::uint64_t ticks = std::uint64_t{high} << 32 | low;
      return Cycles{static_cast<std::int64_t>(ticks * m::kLogicCycles / m::kTimerTicks)};
    }
    high = again;
  }
}

void BoardBus::charge(Work work, std::int64_t times) noexcept {
  armature_charge(static_cast<std::uint32_t>(work), static_cast<std::uint32_t>(times));
}

}  // namespace armature::board
