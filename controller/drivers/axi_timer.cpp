#include "controller/drivers/axi_timer.hpp"

#include "controller/base/timebase.hpp"
#include "controller/regs/axi_timer_regs.hpp"

namespace armature {
namespace {

using namespace regs::axi_timer;

static_assert(kClkFreqHz == regs::soc::kClkFreqHz && kTickCycles.value() == regs::soc::kTickCycles);

constexpr std::int64_t kReloadCycles = 2;  // a period is TLR + 2 cycles
constexpr std::uint32_t kRunning = kTcsr0UdtMask | kTcsr0GentMask | kTcsr0ArhtMask | kTcsr0EnitMask | kTcsr0EntMask;

}  // namespace

void AxiTimer::start(Cycles period) noexcept {
  bus_.write32(base_ + kTlr0Offset, static_cast<std::uint32_t>(period.value() - kReloadCycles));
  bus_.write32(base_ + kTcsr0Offset, kTcsr0LoadMask);
  bus_.write32(base_ + kTcsr0Offset, kRunning);
}

void AxiTimer::acknowledge() noexcept {
  bus_.write32(base_ + kTcsr0Offset, kRunning | kTcsr0TintMask);
}

}  // namespace armature
