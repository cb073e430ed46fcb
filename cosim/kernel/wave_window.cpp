#include "cosim/kernel/wave_window.hpp"

#include <utility>

#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

constexpr Cycles kAfterFault{kClkFreqHz / 1000};  // 1 ms

}  // namespace

WaveWindow::WaveWindow(std::optional<WaveRequest> request) {
  if (!request) return;
  request_ = *std::move(request);
  state_ = State::kWaiting;
}

std::optional<Cycles> WaveWindow::next_event() const {
  if (state_ == State::kWaiting && !request_.on_fault) return request_.from.value_or(Cycles{0});
  if (state_ == State::kOpen) return request_.to;
  return std::nullopt;
}

void WaveWindow::advance(Cycles now, Soc& soc) {
  if (next_event() > now || !next_event()) return;
  if (state_ == State::kWaiting) {
    open(now, soc);
  } else {
    soc.close_wave();
    state_ = State::kDone;
  }
}

void WaveWindow::fault(Cycles now, Soc& soc) {
  if (state_ != State::kWaiting || !request_.on_fault || now < request_.from.value_or(Cycles{0})) return;
  if (!request_.to) request_.to = now + kAfterFault;
  open(now, soc);
}

void WaveWindow::open(Cycles now, Soc& soc) {
  soc.open_wave(request_.file, request_.format);
  state_ = State::kOpen;
  was_open_ = true;
  if (request_.to && *request_.to <= now) advance(now, soc);
}

}  // namespace armature::cosim
