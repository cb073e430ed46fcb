#include "cosim/kernel/wave_window.hpp"

#include <utility>

namespace armature::cosim {

WaveWindow::WaveWindow(std::optional<WaveRequest> request) {
  if (!request) return;
  request_ = *std::move(request);
  state_ = State::kWaiting;
}

std::optional<Cycles> WaveWindow::next_event() const {
  if (state_ == State::kWaiting) return request_.from.value_or(Cycles{0});
  if (state_ == State::kOpen) return request_.to;
  return std::nullopt;
}

void WaveWindow::advance(Cycles now, Soc& soc) {
  if (next_event() > now || !next_event()) return;
  if (state_ == State::kWaiting) {
    soc.open_wave(request_.file, request_.format);
    state_ = State::kOpen;
    was_open_ = true;
  } else {
    soc.close_wave();
    state_ = State::kDone;
  }
}

}  // namespace armature::cosim
