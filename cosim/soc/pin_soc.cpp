#include "cosim/soc/pin_soc.hpp"

#include <algorithm>
#include <utility>

namespace armature::cosim {

PinSoc::PinSoc(std::unique_ptr<Fabric> fabric, const BusSpec& bus, std::uint64_t seed)
    : fabric_{std::move(fabric)}, master_{bus, seed}, access_timeout_{bus.timeout_cycles} {}

bool PinSoc::advance(Cycles limit, StopOn stop_on) {
  if (!clock_running_) {
    if (now() < limit) fabric_->stand_still((limit - now()).value());
    return false;
  }
  const std::uint8_t irq = interrupts();
  for (Cycles here = now(); here < limit; here = now()) {
    const bool busy = !master_.idle();
    const Cycles next = busy ? std::clamp(master_.next_event(), here + Cycles{1}, limit) : limit;
    const bool pins_changed = fabric_->run((next - here).value());
    const bool finished = busy && step_access();
    const bool stopped = stop_on == StopOn::kPinChange   ? pins_changed
                         : stop_on == StopOn::kInterrupt ? pins_changed && interrupts() != irq
                                                         : false;
    if (stopped || finished) return stopped;
  }
  return false;
}

void PinSoc::set_clock_running(bool running) {
  if (running && !clock_running_) master_.stood_still(now() - stopped_at_);
  if (!running) stopped_at_ = now();
  clock_running_ = running;
}

std::optional<Cycles> PinSoc::start(const BusRequest& request) {
  master_.start(request, now());
  return std::nullopt;
}

std::optional<BusResponse> PinSoc::pop_response() {
  return std::exchange(response_, std::nullopt);
}

bool PinSoc::step_access() {
  if (now() < master_.next_event()) return false;
  response_ = master_.step(now(), fabric_->slave());
  fabric_->set_master(master_.pins());
  if (response_) {
    constexpr std::uint64_t kOddFactor = 0x9E37'79B9'7F4A'7C15;
    const std::uint64_t kind = static_cast<std::uint64_t>(response_->error) << 32;
    responses_ = (responses_ ^ response_->data ^ kind) * kOddFactor + static_cast<std::uint64_t>(now().value());
  }
  return response_.has_value();
}

void PinSoc::open_wave(const std::filesystem::path& file, WaveFormat format) {
  fabric_->open_wave(file, format);
}

}  // namespace armature::cosim
