#include "cosim/fault/injector.hpp"

#include <cstddef>
#include <variant>

#include "cosim/time/clock.hpp"

namespace armature::cosim {

void FaultInjector::begin(const FaultKind& kind) {
  std::visit([this](const auto& fault) { start(fault); }, kind);
}

void FaultInjector::end(const FaultKind& kind) {
  std::visit(
      [this]<class Kind>(const Kind& fault) {
        if constexpr (FaultWithDuration<Kind>) stop(fault);
      },
      kind);
}

void FaultInjector::apply_to(SocInputs& pins) const {
  if (estops_ > 0) pins.estop_n = false;
}

void FaultInjector::start(const PulseLoss& fault) {
  targets_.plant.drop_pulses(static_cast<std::size_t>(fault.axis - 1), fault.count);
}

void FaultInjector::start(const SlowCore& fault) {
  targets_.processor.set_tick_compute(to_cycles(fault.compute_us * 1e-6));
}

void FaultInjector::start(const Estop&) {
  ++estops_;
}
void FaultInjector::stop(const Estop&) {
  --estops_;
}

void FaultInjector::start(const ClockStop&) {
  ++clock_stops_;
  targets_.soc.set_clock_running(false);
}
void FaultInjector::stop(const ClockStop&) {
  if (--clock_stops_ == 0) targets_.soc.set_clock_running(true);
}

void FaultInjector::start(const StrayWrite& fault) {
  targets_.processor.write_astray(static_cast<std::uint32_t>(fault.address), static_cast<std::uint32_t>(fault.data));
}

void FaultInjector::start(const BlockHang& fault) {
  blocks_hang_ = true;
  targets_.soc.stop_clock_of(fault.clock);
}

}  // namespace armature::cosim
