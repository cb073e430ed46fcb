#include "cosim/iss/mpcore_model.hpp"

#include "controller/board/mpcore.hpp"

namespace armature::cosim::iss {
namespace {

namespace m = board::mpcore;

constexpr std::uint32_t kNoInterrupt = 1023;  // ICCIAR: nothing is pending
constexpr std::uint32_t kSoftwareId = 0x3FF;  // ICDSGIR, ICCIAR: the number of the interrupt

constexpr std::uint32_t bits(Interrupts lines) {
  return static_cast<std::uint32_t>(lines);
}
constexpr std::uint32_t kLogicLines = bits(Interrupts::kTimer | Interrupts::kUart | Interrupts::kGpio);

constexpr Interrupts lines_of(std::uint32_t value) {
  return static_cast<Interrupts>(value >> m::kFirstLogicBit & kLogicLines);
}

// Of the global timer. The first tick that is not before the cycle, so that the firmware computes the same cycle.
std::uint64_t timer_of(Cycles now) {
  return (static_cast<std::uint64_t>(now.value()) * m::kTimerTicks + m::kLogicCycles - 1) / m::kLogicCycles;
}

}  // namespace

std::uint32_t MpcoreModel::read(std::uint32_t offset, RegisterBus* bus) {
  const bool event = (pending_ & Interrupts::kEvent) != Interrupts::kNone;
  switch (offset) {
    case m::kTimerLow:
      return bus == nullptr ? 0 : static_cast<std::uint32_t>(timer_of(bus->now()));
    case m::kTimerHigh:
      return bus == nullptr ? 0 : static_cast<std::uint32_t>(timer_of(bus->now()) >> 32);
    case m::kIcdPending:
      return event ? 1u << m::kEventId : 0;
    case m::kIcdPending + 4 * m::kLogicWord:
      return (bits(pending_) & kLogicLines) << m::kFirstLogicBit;
    case m::kIccAcknowledge:
      if (!event) return kNoInterrupt;
      pending_ = static_cast<Interrupts>(bits(pending_) & ~bits(Interrupts::kEvent));
      return m::kEventId;
    default:
      return 0;
  }
}

void MpcoreModel::write(std::uint32_t offset, std::uint32_t value, RegisterBus* bus) {
  switch (offset) {
    case m::kIcdEnable + 4 * m::kLogicWord:
      enabled_ = enabled_ | lines_of(value);
      break;
    case m::kIcdDisable + 4 * m::kLogicWord:
      enabled_ = static_cast<Interrupts>(bits(enabled_) & ~bits(lines_of(value)));
      break;
    case m::kIcdSoftware:
      if (bus != nullptr && (value & kSoftwareId) == m::kEventId) bus->send_event();
      break;
    default:
      break;
  }
}

}  // namespace armature::cosim::iss
