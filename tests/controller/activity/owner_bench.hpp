// ArmOwner and the queue of moves without core 0: the test reads what they send, and answers.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "controller/activity/arm_owner.hpp"
#include "controller/activity/move_queue.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature::test {

class OwnerBench {
 public:
  explicit OwnerBench(const PerAxis<Radians>& start = kReady) : start_{start} {}

  // Core 0 reports that the arm stands where the bench started.
  void at_rest() { owner.on_answer(rest_at(start_)); }
  void notify(Answer::Kind kind, const PerAxis<Radians>& position = {}) {
    owner.on_answer({.kind = kind, .position = position, .referenced = 0x3F});
  }
  static Answer rest_at(const PerAxis<Radians>& position, std::uint8_t referenced = 0x3F) {
    return {.kind = Answer::Kind::kRest, .position = position, .referenced = referenced};
  }

  [[nodiscard]] std::vector<std::uint32_t> refused(Refusal reason) const {
    std::vector<std::uint32_t> tags;
    for (const MoveRefused& refusal : refusals) {
      if (refusal.reason == reason) tags.push_back(refusal.tag.number());
    }
    return tags;
  }

  const RobotModel robot = irb120();
  const Arm arm{robot};
  const std::unique_ptr<Channel> channel = std::make_unique<Channel>();  // too large for a stack
  Inbox program;
  std::vector<MoveRefused> refusals;

 private:
  struct Listener final : EventListener {
    explicit Listener(std::vector<MoveRefused>& refusals) : refusals_{refusals} {}
    void on_event(const Event& event) noexcept override {
      if (const auto* refusal = std::get_if<MoveRefused>(&event)) refusals_.push_back(*refusal);
    }
    std::vector<MoveRefused>& refusals_;
  };

 public:
  Listener events{refusals};
  ArmOwner owner{robot, *channel, events};
  MoveQueue queue{program, events};

 private:
  const PerAxis<Radians> start_;
};

}  // namespace armature::test
