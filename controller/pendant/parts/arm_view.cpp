#include "controller/pendant/parts/arm_view.hpp"

#include <utility>
#include <variant>

#include "controller/base/overloaded.hpp"

namespace armature::pendant {

State ArmView::state(Cycles now) const noexcept {
  if (estop_) return State::kEstop;
  if (!started_) return State::kOff;
  if (alarm_) return State::kAlarm;
  if (!drives_on()) return State::kIdle;
  if (program_.active()) return program_.state() == ProgramClient::State::kRunning ? State::kRun : State::kHold;
  if (jogs(now)) return State::kJog;
  return moves(now) ? State::kMove : State::kReady;
}

std::int32_t ArmView::alarm() const noexcept {
  if (!owner_.fault() || owner_.fault()->cause == FaultCause::kDrivesOff) return 0;
  return kAlarmCause.with(static_cast<std::int32_t>(owner_.fault()->cause)) + kAlarmAxis.with(owner_.fault()->axis);
}

void ArmView::on_event(const Event& event) noexcept {
  std::visit(Overloaded{[this](const Faulted& fault) {
                          started_ = true;
                          estop_ = estop_ || fault.cause == FaultCause::kEstop;
                          alarm_ = fault.cause != FaultCause::kDrivesOff;
                        },
                        [this](const FaultCleared&) {
                          started_ = true;
                          alarm_ = false;
                        },
                        [this](const HomingStarted& start) {
                          if (start.tag.source() == Source::kPendant) axes_to_home_ |= std::exchange(homing_asked_, 0);
                        },
                        [this](const HomingEnded& end) { axes_to_home_ = OwnerState::axes_after(end, axes_to_home_); },
                        [](const auto&) {}},
             event);
}

}  // namespace armature::pendant
