// Core 1: takes commands, refuses what cannot be done, plans the rest and hands it to the motion loop.
//
// A move is checked when it arrives and planned from where the move before it ends, so plans follow each other without
// a pause; only then its duration is known, and one longer than kLongestMove is refused. Stop and ClearFault overtake
// waiting moves; what is planned after them starts where the arm then stands.
//
// No move is lost silently: each one is started or reported as refused, those that a Stop or a fault drops included.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/command/command.hpp"
#include "controller/core/axes.hpp"
#include "controller/core/spsc_queue.hpp"
#include "controller/core/units.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/motion/controller_observer.hpp"
#include "controller/motion/mailbox.hpp"
#include "controller/motion/telemetry.hpp"
#include "controller/robot/robot_model.hpp"
#include "controller/trajectory/synchronise.hpp"

namespace armature {

// Why a move cannot be done, nothing when it can: targets must be finite and inside the soft limits, the speed in (0,
// 1]. Joint moves are monotonic, so a target inside the limits keeps the whole move inside.
[[nodiscard]] std::optional<MoveRefusal> find_refusal(const RobotModel& robot, const JointMove& move) noexcept;

class Dispatcher {
 public:
  static constexpr std::size_t kInbox = 16;
  static constexpr std::size_t kWaitingMoves = 16;
  using Inbox = SpscQueue<Command, kInbox>;

  // References must outlive the dispatcher.
  Dispatcher(const RobotModel& robot, SyncRule sync, Inbox& inbox, MotionMailbox& mailbox,
             ControllerObserver& observer) noexcept;
  Dispatcher(const Dispatcher&) = delete;
  Dispatcher& operator=(const Dispatcher&) = delete;

  // The main of core 1: serves events until the core is switched off.
  void run(RegisterBus& bus) noexcept;

 private:
  enum class Mode : std::uint8_t {
    kAwaitingRest,  // the motion loop will say where the arm stands; moves wait
    kReady,         // planned_end_ is where the next plan starts
    kFault,         // moves are refused
    kUnusable,      // so is ClearFault: nobody would answer it
  };

  void serve(RegisterBus& bus) noexcept;
  void hear(const MotionNews& news) noexcept;
  template <class Other>
  void take(const Other&) noexcept {
    refuse(Refusal::kNotReady);
  }
  void take(const JointMove& move) noexcept;
  void take(const Stop& stop) noexcept;
  void take(const ClearFault& clear) noexcept;
  void order(MotionOrder order) noexcept;
  void drop_waiting() noexcept;
  void refuse(Refusal reason) noexcept;

  const RobotModel& robot_;
  SyncRule sync_;
  Inbox& inbox_;
  MotionMailbox& mailbox_;
  ControllerObserver& observer_;
  Mode mode_ = Mode::kAwaitingRest;
  PerAxis<Radians> planned_end_{};
  SpscQueue<JointMove, kWaitingMoves> waiting_;  // accepted, not yet planned
};

}  // namespace armature
