// Which activity has the arm, as core 1 knows it. Nothing else on core 1 stores that.
//
// Plans have the arm by default. Another activity borrows it, from rest to rest: begin() sends its first request to
// core 0. Core 0 reports with each rest where the arm stands, and which joint angles are known. Until then moves wait.
//
// A stop and a fault end whatever has the arm, and drop whatever waits: every move is either started or reported as
// refused.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "controller/activity/activity.hpp"
#include "controller/activity/channel.hpp"
#include "controller/activity/owner_state.hpp"
#include "controller/base/axes.hpp"
#include "controller/base/tag.hpp"
#include "controller/base/units.hpp"
#include "controller/message/command.hpp"
#include "controller/message/event.hpp"
#include "controller/robot/robot_model.hpp"

namespace armature {

class ArmOwner {
 public:
  static constexpr std::size_t kMaxActivities = 10;

  // References must outlive the object.
  ArmOwner(const RobotModel& robot, Channel& channel, EventListener& events) noexcept
      : robot_{robot}, channel_{channel}, events_{events} {}
  ArmOwner(const ArmOwner&) = delete;
  ArmOwner& operator=(const ArmOwner&) = delete;

  // Call before the first answer is read. They drop in this order.
  template <class... Activities>
  void set_activities(Activities&... activities) noexcept {
    static_assert(sizeof...(Activities) <= kMaxActivities);
    activities_ = {&activities...};
    count_ = sizeof...(Activities);
  }

  // The activity has the arm, and was not told to end.
  [[nodiscard]] bool has(ActivityId activity) const noexcept { return phase_ == Phase::kOwned && owner_ == activity; }
  [[nodiscard]] bool in_fault() const noexcept { return phase_ == Phase::kFault || phase_ == Phase::kUnusable; }
  // All joint angles are known, as far as core 1 knows.
  [[nodiscard]] bool referenced() const noexcept { return referenced_; }
  // Where the arm will stand at the end of all that core 0 has; on the conveyor in the frame of the plans. Valid while
  // plans or the conveyor have the arm.
  [[nodiscard]] const PerAxis<Radians>& end() const noexcept { return end_; }
  void set_end(const PerAxis<Radians>& joints) noexcept { end_ = joints; }
  // Where the arm stands when all commands are over and nothing holds it; otherwise nothing.
  [[nodiscard]] std::optional<PerAxis<Radians>> rest() const noexcept;

  // What core 0 has reported. on_event() gets each event of core 0, before a client of core 1 executes again.
  [[nodiscard]] const OwnerState& reported() const noexcept { return reported_; }
  void on_event(const Event& event) noexcept { reported_.on_event(event); }

  // `to` has the arm, from rest() on or still, until core 0 reports that the arm stands. begin() must follow.
  void lend(ActivityId to) noexcept;
  // The same, and sends what core 0 begins with.
  template <class T>
  void begin(ActivityId to, const T& content) noexcept {
    send(Request::Kind::kBegin, to, ++sent_, content);
    lend(to);
  }
  // More for the activity that has the arm.
  template <class T>
  void feed(ActivityId to, const T& content) noexcept {
    send(Request::Kind::kFeed, to, sent_, content);
  }
  // The activity was asked to end; only a quick stop is stronger.
  void release() noexcept { await_rest(StopKind::kSoft); }
  // Brings the arm to rest, whatever has it, unless it is ending in a way that is not weaker.
  void stop(StopKind how) noexcept;
  // Drops whatever core 0 does not have.
  void drop(Refusal why) noexcept;
  // A joint move has replaced all that came before it. The arm will stand at `end`.
  void replace(const PerAxis<Radians>& end) noexcept;

  [[nodiscard]] std::optional<MoveRefused> accept(const Hold& hold) noexcept;
  [[nodiscard]] std::optional<MoveRefused> accept(const Resume& resume) noexcept;
  [[nodiscard]] std::optional<MoveRefused> accept(const SetOverride& wanted) noexcept;
  [[nodiscard]] std::optional<MoveRefused> accept(const Stop& stop) noexcept;
  [[nodiscard]] std::optional<MoveRefused> accept(const ClearFault& clear) noexcept;
  [[nodiscard]] std::optional<MoveRefused> accept(const SwitchOff& off) noexcept;

  // Reads what core 0 has answered.
  void read_answers() noexcept;
  void on_answer(const Answer& answer) noexcept;

 private:
  enum class Phase : std::uint8_t {
    kOwned,
    kAwaitingRest,  // the start, a stop and an order, until core 0 answers
    kFault,         // moves are refused
    kUnusable,      // ClearFault is refused as well, because core 0 would not answer it
  };

  void on_rest(const Answer& answer) noexcept;
  void on_fault() noexcept;
  void order(Request::Kind kind) noexcept;
  void await_rest(StopKind how) noexcept;
  template <class T>
  void send(Request::Kind kind, ActivityId to, std::uint32_t number, const T& content) noexcept {
    channel_.send(kind, to, number, [&](Request& request) { request.set(content); });
  }
  template <class Action>
  void for_each(Action action) const noexcept {
    for (std::size_t i = 0; i < count_; ++i) action(*activities_[i]);
  }

  const RobotModel& robot_;
  Channel& channel_;
  EventListener& events_;
  std::array<Activity*, kMaxActivities> activities_{};
  std::size_t count_ = 0;
  Phase phase_ = Phase::kAwaitingRest;
  ActivityId owner_ = ActivityId::kPlans;
  PerAxis<Radians> end_{};
  bool referenced_ = true;
  OwnerState reported_{};
  StopKind ending_ = StopKind::kQuick;  // in kAwaitingRest: the strongest stop that was sent
  std::uint32_t sent_ = 0;              // number of the newest request that core 0 answers; wraps
  Tag clear_tag_{};                     // of the ClearFault that core 0 has not answered yet
};

}  // namespace armature
