#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <utility>

#include "cosim/kernel/simulation.hpp"

namespace armature::cosim {
namespace {

// By BusError.
constexpr std::array kBusErrorTexts{"ok", "the slave answered SLVERR", "no slave at this address (DECERR)",
                                    "no answer within the time-out"};
static_assert(kBusErrorTexts.size() == kBusErrorNames.size());

}  // namespace

// One access at a time.
void Simulation::grant_bus() {
  access_ = processor_->next_access();
  if (!access_) return;
  if (ticks_.disturbs(access_->request)) compute_edges();
  access_since_ = now();
  soc_->start(access_->request);
}

// Ends the access whose response has come, if no fault delays it.
void Simulation::take_response() {
  if (!response_) {
    response_ = soc_->pop_response();
    response_due_ = now() + injector_.response_delay();
  }
  if (!response_ || response_due_ > now()) return;
  finish_access(*std::exchange(response_, std::nullopt));
}

void Simulation::finish_access(BusResponse response) {
  bus_time_.at(static_cast<std::size_t>(access_->core)) += now() - access_since_;
  const Processor::Access access = *std::exchange(access_, std::nullopt);
  const BusRequest& request = access.request;
  if (injector_.takes_for_error(request.addr)) {
    // The fault spoils the response of an access that the logic has executed.
    if (request.write && response.error == BusError::kNone) conservation_.on_write(now(), request.addr, request.data);
    response = {.error = BusError::kSlaveError, .data = 0};
  }
  if (response.error != BusError::kNone && (access.stray || injector_.explains_bus_errors())) {
    processor_->abort(access, now());
    listener_.on_signal(BusAbort{.access = access, .error = response.error}, now());
    return;
  }
  if (response.error != BusError::kNone) {
    fail(fmt::format("bus: {} at 0x{:08X} by core {}: {} (cycle {})", request.write ? "write" : "read", request.addr,
                     access.core, kBusErrorTexts.at(static_cast<std::size_t>(response.error)), now().value()));
    return;
  }
  if (!check_access(request, response.data, now())) return;
  processor_->complete(access, response, now());
  read_host_memory();
}

void Simulation::fail_conservation() {
  fail(*conservation_.violation());
}

}  // namespace armature::cosim
