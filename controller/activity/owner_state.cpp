#include "controller/activity/owner_state.hpp"

#include <variant>

#include "controller/base/overloaded.hpp"

namespace armature {

void OwnerState::on_event(const Event& event) noexcept {
  std::visit(Overloaded{[this](const MoveStarted&) { ++moves_; }, [this](const MoveFinished&) { --moves_; },
                        [this](const JogStarted&) { jogs_ = true; }, [this](const JogEnded&) { jogs_ = false; },
                        [this](const HomingStarted& start) {
                          homing_ = static_cast<std::uint8_t>(homing_ | 1U << (start.axis - 1U));
                        },
                        [this](const HomingEnded& end) { homing_ = axes_after(end, homing_); },
                        [this](const Faulted& fault) {
                          fault_ = fault;
                          jogs_ = false;
                        },
                        [this](const FaultCleared&) { fault_.reset(); }, [](const auto&) {}},
             event);
}

}  // namespace armature
