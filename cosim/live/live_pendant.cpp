#include "cosim/live/live_pendant.hpp"

#include <algorithm>
#include <cstddef>

#include "controller/base/timebase.hpp"

namespace armature::cosim {
namespace {

constexpr std::int64_t kCyclesPerUs = kClkFreqHz / 1'000'000;

bool moves(const OperatorLink& link) {
  using pendant::State;
  const std::optional<State> state = link.state();
  return state == State::kJog || state == State::kMove || state == State::kRun;
}

}  // namespace

void LivePendant::exchange(Cycles now, std::size_t room, std::vector<std::uint8_t>& in) {
  now_ = Time{now.value() / kCyclesPerUs};
  if (now_ < kControllerBegins) return;
  watch_operator();
  link_.poll(now_, waiting_);
  const auto count = static_cast<std::ptrdiff_t>(std::min(room, waiting_.size()));
  in.insert(in.end(), waiting_.begin(), waiting_.begin() + count);
  waiting_.erase(waiting_.begin(), waiting_.begin() + count);
}

void LivePendant::set_operator(bool there) {
  if (operator_ && !there) {
    link_.say("nobody is at the page: the arm is stopped");
    link_.let_go();
    next_stop_ = now_ + kStopEvery;
  }
  must_release_ = must_release_ || !there;
  operator_ = there;
}

void LivePendant::release_jog() {
  must_release_ = false;
  link_.release_jog();
}

void LivePendant::watch_operator() {
  if (operator_ || now_ < next_stop_ || !moves(link_)) return;
  next_stop_ = now_ + kStopEvery;
  link_.let_go();
}

void LivePendant::jog(pendant::System system, std::uint8_t axis, std::int32_t velocity) {
  if (!operator_ || must_release_) return;
  if (link_.coordinates() == static_cast<int>(system)) return link_.jog(axis, velocity, now_ + kJogLasts);
  if (now_ < next_system_) return;  // the telemetry has not told yet
  next_system_ = now_ + 2 * OperatorLink::kTelemetryPeriod;
  link_.press({.opcode = pendant::Opcode::kSetCoordinates, .parameter = static_cast<std::uint8_t>(system)});
}

}  // namespace armature::cosim
