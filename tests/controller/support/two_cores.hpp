// Core 1, which plans, and the plans on core 0, in one thread and without the logic.
//
// What core 1 computes takes its time: as it is charged, the ticks of core 0 pass. So a plan that takes too long comes
// too late, as on the robot. The costs are those of [cpu] in scenario files; `cost` can be changed.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "controller/activity/plans/plan_source.hpp"
#include "controller/app/core1_loop.hpp"
#include "controller/base/timebase.hpp"
#include "controller/command/dispatcher.hpp"
#include "controller/language/program/program_client.hpp"
#include "cosim/cpu/cpu_spec.hpp"

namespace armature::test {

class TwoCores final : private RegisterBus, private EventListener {
 public:
  TwoCores(const RobotModel& model, const PlanningConfig& config, const JointAngles& start)
      : robot{model}, config_{config}, start_{start} {
    loop_.add(program);
    loop_.add(dispatcher_);
    runner_.reset_to(start);
  }
  TwoCores(const TwoCores&) = delete;
  TwoCores& operator=(const TwoCores&) = delete;

  // The moves that a host sends, from the start on and as fast as there is room for them.
  std::vector<Command> commands;

  // Asked in each tick of core 0: whether the host sends this one of `commands`.
  std::function<bool(std::size_t)> may_send = [](std::size_t) { return true; };
  cosim::CpuSpec cost;

  // Once: until the arm has executed everything, or for so many ticks. False: it has not.
  [[nodiscard]] bool run(std::int64_t most_ticks) {
    most_ticks_ = most_ticks;
    EXPECT_TRUE(channel_->loop.answers.try_push({.kind = Answer::Kind::kRest, .position = start_, .referenced = 0x3F}));
    event_ = true;
    loop_.run(*this);
    return tick_ < most_ticks;
  }
  // Asked in each tick of core 0 when the host has sent everything.
  std::function<bool()> is_over = [] { return true; };

  const RobotModel robot;
  const Arm arm{robot};
  std::vector<JointAngles> joints;  // the set-point of each tick
  std::vector<MoveStarted> started;
  std::vector<MoveFinished> finished;
  std::vector<MoveRefused> refused;

 private:
  // RegisterBus of core 1, which accesses no register here.
  std::uint32_t read32(RegAddr) noexcept override { return 0; }
  void write32(RegAddr, std::uint32_t) noexcept override {}
  void send_event() noexcept override {}
  [[nodiscard]] Cycles now() noexcept override { return now_; }
  void charge(Work work, std::int64_t times) noexcept override { pass(Cycles{cosim::cycles_of(cost, work) * times}); }
  Interrupts wait_for_interrupt(Interrupts) noexcept override {
    while (!event_) {
      if (over_) return Interrupts::kNone;
      pass(next_trigger() - now_);
    }
    event_ = false;
    return Interrupts::kEvent;
  }
  [[nodiscard]] Cycles next_trigger() const { return Cycles{kTickCycles.value() * (tick_ + 1)}; }
  void pass(Cycles time) {
    now_ = now_ + time;
    while (next_trigger() <= now_) tick();
  }
  void tick() {
    if (over_) return void(++tick_);  // core 1 finishes its work
    while (sent_ < commands.size() && may_send(sent_) &&
           inbox_of(inboxes_, Source::kProgram).try_push(commands[sent_])) {
      ++sent_;
      event_ = true;
    }
    const RunControl::View control = channel_->control.view();
    for (; const Request* request = channel_->requests.front(); channel_->requests.drop_front()) {
      channel_->loop.number = request->number;
      if (request->kind == Request::Kind::kStop) {
        runner_.stop(request->stop);
      } else {
        runner_.feed(*request);
      }
    }
    const SetPoint& point = runner_.advance(Ticks{tick_++}, control);
    event_ = event_ || point.wake || channel_->loop.wake_each_tick.load();
    joints.push_back(point.position);
    const bool all =
        sent_ == commands.size() && runner_.at_rest() && dispatcher_.owner().rest().has_value() && is_over();
    over_ = all || tick_ >= most_ticks_;
  }

  // Of core 0, and of core 1.
  void on_event(const Event& event) noexcept override { keep(event); }
  struct Core0 final : EventListener {
    explicit Core0(TwoCores& cores) : cores_{cores} {}
    void on_event(const Event& event) noexcept override {
      cores_.keep(event);
      EXPECT_TRUE(cores_.channel_->events.try_push(event));
      cores_.event_ = true;
    }
    TwoCores& cores_;
  };
  void keep(const Event& event) {
    if (const auto* move = std::get_if<MoveStarted>(&event)) started.push_back(*move);
    if (const auto* move = std::get_if<MoveFinished>(&event)) finished.push_back(*move);
    if (const auto* move = std::get_if<MoveRefused>(&event)) refused.push_back(*move);
  }

  const PlanningConfig config_;
  const JointAngles start_;
  const std::unique_ptr<Channel> channel_ = std::make_unique<Channel>();
  Inboxes inboxes_;
  ToolIo tool_;
  Core1Loop loop_{*channel_, *this};
  Core0 core0_{*this};
  PlanSource runner_{robot, arm, *channel_, core0_};
  const std::unique_ptr<Dispatcher> owned_ =
      std::make_unique<Dispatcher>(robot, arm, config_, inboxes_, *channel_, tool_, loop_);
  Dispatcher& dispatcher_ = *owned_;

 public:
  ProgramClient program{inboxes_, dispatcher_.owner(), tool_, loop_};

 private:
  Cycles now_{};
  std::int64_t tick_ = 0, most_ticks_ = 0;
  std::size_t sent_ = 0;
  bool event_ = false, over_ = false;
};

}  // namespace armature::test
