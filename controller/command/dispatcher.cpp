#include "controller/command/dispatcher.hpp"

#include <tuple>
#include <type_traits>
#include <variant>

namespace armature {
namespace {

template <class Taker, class C>
concept Takes = requires(Taker& taker, const C& command) {
  taker.accept(command);
};

}  // namespace

Dispatcher::Dispatcher(const RobotModel& robot, const Arm& arm, const PlanningConfig& config, Inboxes& inboxes,
                       Channel& channel, ToolIo& tool, EventListener& events) noexcept
    : inboxes_{inboxes},
      events_{events},
      frames_{config.base_T_user},
      owner_{robot, channel, events},
      queue_{inbox_of(inboxes, Source::kProgram), events},
      pins_{tool, queue_, events},
      activities_{{robot, arm, config, frames_, owner_, queue_, channel, events}} {
  // What is planned was accepted before what waits.
  Activities& a = activities_;
  owner_.set_activities(a.plans, a.conveyor, pins_, queue_, a.plans.retarget(), a.jog, a.homing, a.stream,
                        static_cast<Activity&>(*this));
}

bool Dispatcher::execute(RegisterBus& bus) noexcept {
  owner_.read_answers();
  Inbox& program = inbox_of(inboxes_, Source::kProgram);
  for (Inbox& inbox : inboxes_) {
    if (&inbox == &program && dropping_program_) drop_program();
    while ((&inbox != &program || !queue_.full()) && accept_next(inbox)) {
    }
  }
  activities_.jog.send();
  activities_.plans.retarget().send();
  const std::int64_t inverses = activities_.stream.take_inverses() + activities_.conveyor.take_inverses();
  if (inverses > 0) bus.charge(Work::kInverse, inverses);
  return execute_next(bus) || dropping_program_.has_value();
}

bool Dispatcher::accept_next(Inbox& inbox) noexcept {
  const std::optional<Command> command = inbox.try_pop();
  if (!command) return false;
  const auto accept_it = [this](const auto& content) {
    std::optional<MoveRefused> refusal = accept(content);
    if (!refusal) return;
    if constexpr (requires { content.tag; }) refusal->tag = content.tag;
    events_.on_event(*refusal);
  };
  std::visit(accept_it, *command);
  return true;
}

template <class C>
std::optional<MoveRefused> Dispatcher::accept(const C& command) noexcept {
  std::optional<MoveRefused> refusal;
  const auto offer = [&]<class Taker>(Taker& taker) {
    if constexpr (Takes<Taker, C>) refusal = taker.accept(command);
  };
  const auto offer_to_each = [&]<class... Taker>(Taker&... taker) {
    static_assert((int{Takes<Taker, C>} + ...) == 1, "one of them takes each command");
    (offer(taker), ...);
  };
  std::apply(offer_to_each, std::tuple_cat(std::tie(owner_), activities_.all()));
  return refusal;
}

// Until the inbox is found empty: more may wait in the memory that the host fills.
void Dispatcher::drop_program() noexcept {
  bool any = false;
  while (const std::optional<Command> command = inbox_of(inboxes_, Source::kProgram).try_pop()) {
    any = true;
    const auto refuse_it = [this](const auto& content) {
      if constexpr (requires { content.tag; }) {
        events_.on_event(refused(*dropping_program_, content.tag));
      }
    };
    std::visit(refuse_it, *command);
  }
  if (!any) dropping_program_.reset();
}

bool Dispatcher::execute_next(RegisterBus& bus) noexcept {
  PlanActivity& plans = activities_.plans;
  if (!owner_.has(ActivityId::kConveyor) && !plans.may_work()) return false;
  if (activities_.conveyor.plans()) return activities_.conveyor.work(bus);
  switch (plans.work(bus)) {
    case PlanActivity::Work::kDone:
      return true;
    case PlanActivity::Work::kWaiting:
      return false;
    case PlanActivity::Work::kNothing:
      break;
  }
  const MoveQueue::Move* next = queue_.front();
  if (next == nullptr) return false;
  return std::visit([&](const auto& move) { return execute(move, bus); }, *next);
}

template <class Move>
bool Dispatcher::execute(const Move& move, RegisterBus& bus) noexcept {
  PlanActivity& plans = activities_.plans;
  ConveyorActivity& conveyor = activities_.conveyor;
  const bool follows = owner_.has(ActivityId::kConveyor);
  const bool stands = follows ? conveyor.stands() : plans.stand();
  if constexpr (requires { pins_.execute(move, stands, bus); }) {
    return pins_.execute(move, stands, bus);
  } else {
    if constexpr (std::is_same_v<Move, CartesianMove>) {
      if (move.target.frame == kConveyorFrame) return conveyor.execute(move, stands, bus);
    }
    if constexpr (std::is_same_v<Move, Dwell>) {
      if (follows) return conveyor.execute(move, bus);
    }
    return follows ? conveyor.release() : plans.execute(move, bus);
  }
}

}  // namespace armature
