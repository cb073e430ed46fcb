#include "cosim/serve/served_soc.hpp"

#include <algorithm>
#include <utility>

namespace armature::cosim {

ServedSoc::ServedSoc(std::unique_ptr<Soc> soc) : soc_{std::move(soc)} {
  soc_->set_inputs(inputs_);
}

BusResponse ServedSoc::access(const BusRequest& request) {
  soc_->start(request);
  for (;;) {
    soc_->advance(now() + kStopCycles, StopOn::kAccess);
    if (const auto response = soc_->pop_response()) return *response;
  }
}

bool ServedSoc::run(Cycles cycles, const StopRequest& stop) {
  const Cycles end = now() + cycles;
  while (now() < end) {
    const Cycles slice = std::min(end, now() + kStopCycles);
    soc_->advance(slice, StopOn::kAccess);
    if (now() < end && stop()) return false;
  }
  return true;
}

std::optional<bool> ServedSoc::run_until_irq(Cycles limit, const StopRequest& stop) {
  const Cycles end = now() + limit;
  const auto active = [this] { return soc_->interrupts() != 0; };
  while (!active() && now() < end) {
    const Cycles slice = std::min(end, now() + kStopCycles);
    while (!active() && now() < slice) soc_->advance(slice, StopOn::kInterrupt);
    if (!active() && now() < end && stop()) return std::nullopt;
  }
  return active();
}

void ServedSoc::set_inputs(const SocInputs& inputs) {
  inputs_ = inputs;
  soc_->set_inputs(inputs_);
}

}  // namespace armature::cosim
