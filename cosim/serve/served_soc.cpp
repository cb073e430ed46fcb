#include "cosim/serve/served_soc.hpp"

#include <algorithm>
#include <utility>

namespace armature::cosim {
namespace {

constexpr std::uint64_t kBusSeed = 1;  // of stalls, for a BusSpec that asks for them

}  // namespace

ServedSoc::ServedSoc(std::unique_ptr<Fabric> fabric, const BusSpec& bus)
    : fabric_{std::move(fabric)}, bus_spec_{bus}, bus_{bus, kBusSeed} {
  fabric_->set_inputs(inputs_);
}

BusResponse ServedSoc::access(const BusRequest& request) {
  bus_.start(request, now());
  for (;;) {
    while (bus_.next_event() > now()) fabric_->run((bus_.next_event() - now()).value());
    const std::optional<BusResponse> response = bus_.step(now(), fabric_->slave());
    fabric_->set_master(bus_.pins());
    if (response) return *response;
  }
}

bool ServedSoc::run(Cycles cycles, const StopRequest& stop) {
  const Cycles end = now() + cycles;
  while (now() < end) {
    const Cycles slice = std::min(end, now() + kStopCycles);
    while (now() < slice) fabric_->run((slice - now()).value());
    if (now() < end && stop()) return false;
  }
  return true;
}

std::optional<bool> ServedSoc::run_until_irq(Cycles limit, const StopRequest& stop) {
  const Cycles end = now() + limit;
  const auto active = [this] { return outputs().irq != 0; };
  while (!active() && now() < end) {
    const Cycles slice = std::min(end, now() + kStopCycles);
    while (!active() && now() < slice) fabric_->run((slice - now()).value());
    if (!active() && now() < end && stop()) return std::nullopt;
  }
  return active();
}

void ServedSoc::set_inputs(const FabricInputs& inputs) {
  inputs_ = inputs;
  fabric_->set_inputs(inputs_);
}

}  // namespace armature::cosim
