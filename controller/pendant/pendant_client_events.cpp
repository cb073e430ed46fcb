// What the events of both cores mean for the pendant: the state of the arm, and answers to commands.
#include <variant>

#include "controller/base/timebase.hpp"
#include "controller/pendant/pendant_client.hpp"
#include "controller/pendant/refusal_status.hpp"

namespace armature::pendant {
namespace {

// The drives can be switched on when the arm has stood for 5 ms; after an alarm it must come to rest before.
constexpr Cycles kStandstill{6 * kMillisecond.value()};
constexpr Cycles kSettling{50 * kMillisecond.value()};

constexpr std::uint8_t bit_of(std::uint8_t axis) noexcept {
  return static_cast<std::uint8_t>(1U << (axis - 1U));
}

}  // namespace

void PendantClient::on_event(const Event& event) noexcept {
  std::visit([this](const auto& content) { on(content); }, event);
}

void PendantClient::on(const MoveStarted& started) noexcept {
  ++moves_;
  if (waits_ && started.tag == waits_for_) answer_ = Answer{};
}

void PendantClient::on(const MoveFinished&) noexcept {
  --moves_;
}

void PendantClient::on(const MoveRefused& refused) noexcept {
  if (refused.tag.source() != Source::kPendant) return;
  if (!waits_ || refused.tag != waits_for_) {
    pressed_.release();  // a jog that was refused did not begin
    return;
  }
  const bool drives = *waits_ == Opcode::kServo && !arm_facts_.servo_on;
  answer_ = drives ? Answer{.status = Status::kAlarm} : Answer{status_of(refused.reason), refused.axis};
}

void PendantClient::on(const IoDone& done) noexcept {
  if (waits_ && done.tag == waits_for_) answer_ = Answer{};
}

void PendantClient::on(const Faulted& faulted) noexcept {
  const bool switched_off = faulted.cause == FaultCause::kDrivesOff;
  arm_facts_ = {
      .started = true, .estop = arm_facts_.estop || faulted.cause == FaultCause::kEstop, .alarm = !switched_off};
  alarm_ = switched_off ? 0 : static_cast<std::int32_t>(faulted.cause) + 256 * faulted.axis;
  pressed_.release();
  jogs_ = false;
  mine_ = false;
  settling_ = switched_off ? kStandstill : kSettling;
  if (waits_ == Opcode::kServo && switched_off) answer_ = Answer{};
}

void PendantClient::on(const FaultCleared&) noexcept {
  arm_facts_ = {.started = true, .estop = arm_facts_.estop, .servo_on = true};
  alarm_ = 0;
  if (waits_ == Opcode::kServo) answer_ = Answer{};
}

void PendantClient::on(const HomingStarted& axis) noexcept {
  homing_ |= bit_of(axis.axis);
  if (!waits_ || axis.tag != waits_for_) return;
  homing_ |= homing_asked_;
  answer_ = Answer{};
}

void PendantClient::on(const HomingEnded& axis) noexcept {
  homing_ = axis.how == HomingEnd::kHomed ? static_cast<std::uint8_t>(homing_ & ~bit_of(axis.axis)) : std::uint8_t{0};
}

}  // namespace armature::pendant
