// A controller on a ModelLogic, with everything it reports recorded.
//
// Core 1 is served at each trigger and takes no time of its own.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "controller/app/controller.hpp"
#include "controller/base/overloaded.hpp"
#include "controller/host_memory/boot_memory.hpp"
#include "controller/host_memory/controller_config.hpp"
#include "controller/host_memory/host_side.hpp"
#include "controller/message/event.hpp"
#include "tests/controller/support/model_logic.hpp"
#include "tests/controller/support/robots.hpp"

namespace armature::test {

// The mains of a controller that was constructed on a memory.
struct ControllerMains {
  std::function<void(RegisterBus&)> core0, core1;
};

class ControllerRig final {
 public:
  explicit ControllerRig(const RobotModel& model = paper_robot(), const ControllerConfig& config = {},
                         const host_memory::BootProgram& program = {})
      : ControllerRig{model, config, program, {}} {
    controller_ = std::make_unique<Controller>(memory_.memory());
    mains_ = {.core0 = [this](RegisterBus& bus) { controller_->core0_main(bus); },
              .core1 = [this](RegisterBus& bus) { controller_->core1_main(bus); }};
  }
  // `start` constructs another controller than the linked one.
  ControllerRig(const RobotModel& model, const ControllerConfig& config, const host_memory::BootProgram& program,
                const std::function<ControllerMains(host_memory::HostMemory&)>& start)
      : robot{model}, memory_{model, config, program} {
    if (start) mains_ = start(memory_.memory());
    logic.fit_drives(robot);
    logic.on_event = [this] { core1_.event = true; };
    logic.on_wait = [this] { read_host_memory(); };
    logic.on_trigger = [this](std::int64_t trigger) {
      for (auto [it, end] = script_.equal_range(trigger); it != end; ++it) it->second();
      on_each_trigger();
      if (!core1_awake()) return;
      const bool event = std::exchange(core1_.event, false);
      if (event || core1_.interrupted()) serve_core1(event);
    };
  }

  // Something to happen right after a trigger.
  void at(std::int64_t trigger, std::function<void()> action) { script_.emplace(trigger, std::move(action)); }
  void submit_at(std::int64_t trigger, const Command& command) {
    at(trigger, [this, command] { submit(command); });
  }
  void submit(const Command& command) {
    EXPECT_TRUE(host_.submit(Source::kScenario, command));
    core1_.event = true;
  }
  // The host publishes this count of the belt from a trigger on.
  void publish_belt(std::int64_t counts) { host_.publish_belt(counts); }
  void move_at(std::int64_t trigger, const PerAxis<double>& target_deg, double speed = 1.0) {
    submit_at(trigger, JointMove{.target = degrees(target_deg), .speed = speed});
  }

  [[nodiscard]] const host_memory::HostMemory& memory() { return memory_.memory(); }

  // Once per rig: runs both cores for so many triggers.
  void run(std::int64_t triggers) {
    logic.triggers_to_run = triggers;
    rows.reserve(static_cast<std::size_t>(triggers));
    core1_.event = true;
    mains_.core0(logic);
    read_host_memory();
    if (!core1_.served) serve_core1(true);
  }

  // By hand, once no trigger does it any more.
  void serve_core1() { serve_core1(true); }

  // Moves that had reached their end when the tick was over; those that were cut short do not count.
  [[nodiscard]] std::int64_t moves_finished(std::int64_t tick = std::numeric_limits<std::int64_t>::max()) const {
    return std::ranges::count_if(finished, [tick](const MoveFinished& move) {
      return move.how == MoveFinished::How::kReachedEnd && move.tick <= Ticks{tick};
    });
  }
  [[nodiscard]] const Telemetry& last() const { return rows.back(); }
  [[nodiscard]] const Telemetry& row(std::int64_t tick) const { return rows.at(static_cast<std::size_t>(tick)); }

  // Nothing was lost between what the controller says and what the pins showed. For runs that end at rest.
  void expect_pulses_conserved() const {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      EXPECT_EQ(logic.emitted(axis), last().commanded[axis].value()) << "axis " << axis + 1;
      EXPECT_EQ((last().reference_pulses[axis] + last().correction[axis]).value(), last().commanded[axis].value())
          << "axis " << axis + 1;
    }
  }
  void expect_at(const PerAxis<double>& target_deg) const {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      EXPECT_EQ(last().reference[axis].value(), target_deg[axis] * kDeg) << "axis " << axis + 1;
      EXPECT_NEAR(static_cast<double>(logic.count(axis)), static_cast<double>(last().reference_pulses[axis].value()),
                  1.0)
          << "axis " << axis + 1;
    }
  }

  // A move of a long program; false when there is no room for it.
  bool submit_program(const Command& command) {
    const bool given = host_.submit(Source::kProgram, command);
    core1_.event = core1_.event || given;
    return given;
  }
  std::function<void()> on_each_trigger = [] {};
  // For its orders, in actions of at().
  ProgramClient& program() { return controller_->program(); }
  void wake_core1() { core1_.event = true; }

  // Called when core 1 charges for work, while it computes: what arrives meanwhile.
  std::function<void(Work, std::int64_t)> on_core1_work = [](Work, std::int64_t) {};

  // Asked at each trigger; while core 1 is not awake its events wait.
  std::function<bool()> core1_awake = [] { return true; };

  const RobotModel robot;  // as the controller has it
  ModelLogic logic;
  std::int64_t core1_reads = 0, core1_writes = 0;
  std::vector<Telemetry> rows;
  std::vector<MoveStarted> moves;
  std::vector<MoveRefused> refusals;
  std::vector<MoveFinished> finished;
  std::vector<Faulted> faults;
  std::vector<FaultCleared> faults_cleared;
  std::vector<JogStarted> jogs;
  std::vector<JogEnded> jogs_ended;
  std::vector<StreamEnded> streams;
  std::vector<OutputSwitched> switched;
  std::vector<PartFollowed> parts;
  std::vector<HomingStarted> homings;
  std::vector<HomingEnded> homings_ended;
  std::vector<ProgramNoted> notes;
  std::vector<std::pair<std::int64_t, IoDone>> io;  // with the triggers until then

 private:
  // Core 1's bus: main returns when there is no event, and is entered again for the next.
  class Core1 final : public RegisterBus {
   public:
    explicit Core1(ControllerRig& rig) : rig_{rig} {}
    bool event = false;
    bool served = false;

    // The GPIO interrupts, and the core sleeps for that.
    [[nodiscard]] bool interrupted() const {
      return rig_.logic.tool_interrupts() && (mask_ & Interrupts::kGpio) != Interrupts::kNone;
    }
    void serve(bool by_event) {
      served = pending_ = true;
      by_event_ = by_event;
      rig_.mains_.core1(*this);
    }
    std::uint32_t read32(RegAddr addr) noexcept override {
      ++rig_.core1_reads;
      return rig_.logic.read(tool_register(addr));
    }
    void write32(RegAddr addr, std::uint32_t value) noexcept override {
      ++rig_.core1_writes;
      rig_.logic.write(tool_register(addr), value);
    }
    Interrupts wait_for_interrupt(Interrupts mask) noexcept override {
      mask_ = mask;
      if (!std::exchange(pending_, false)) return Interrupts::kNone;
      return (by_event_ ? Interrupts::kEvent : Interrupts::kNone) |
             (interrupted() ? Interrupts::kGpio : Interrupts::kNone);
    }
    void send_event() noexcept override {}
    Cycles now() noexcept override { return rig_.logic.now(); }
    void charge(Work work, std::int64_t times) noexcept override { rig_.on_core1_work(work, times); }

   private:
    // No other block is core 1's.
    static RegAddr tool_register(RegAddr addr) {
      EXPECT_EQ(addr.value & 0xFFFF'0000u, ModelLogic::kTool.value);
      return addr;
    }

    ControllerRig& rig_;
    bool pending_ = false;
    bool by_event_ = false;
    Interrupts mask_ = Interrupts::kNone;
  };

  void serve_core1(bool by_event) {
    core1_.serve(by_event);
    read_host_memory();
  }
  // As a host does when a core has run.
  void read_host_memory() {
    while (const std::optional<Event> event = host_.next_event()) {
      std::visit(Overloaded{
                     [this](const MoveStarted& move) { moves.push_back(move); },
                     [this](const MoveFinished& move) { finished.push_back(move); },
                     [this](const MoveRefused& refusal) { refusals.push_back(refusal); },
                     [this](const IoDone& done) {
                       io.push_back({logic.triggers(), done});
                     },
                     [this](const Faulted& fault) { faults.push_back(fault); },
                     [this](const FaultCleared& cleared) { faults_cleared.push_back(cleared); },
                     [this](const JogStarted& jog) { jogs.push_back(jog); },
                     [this](const JogEnded& jog) { jogs_ended.push_back(jog); },
                     [this](const StreamEnded& stream) { streams.push_back(stream); },
                     [this](const OutputSwitched& output) { switched.push_back(output); },
                     [this](const PartFollowed& part) { parts.push_back(part); },
                     [this](const HomingStarted& axis) { homings.push_back(axis); },
                     [this](const HomingEnded& axis) { homings_ended.push_back(axis); },
                     [this](const ProgramNoted& note) { notes.push_back(note); },
                 },
                 *event);
    }
    if (const std::optional<Telemetry> telemetry = host_.new_telemetry()) rows.push_back(*telemetry);
    EXPECT_EQ(host_.lost_events(), 0u);
  }

  host_memory::BootMemory memory_;
  host_memory::HostSide host_{memory_.memory()};
  std::multimap<std::int64_t, std::function<void()>> script_;
  std::unique_ptr<Controller> controller_;  // none if it is another one than the linked one
  ControllerMains mains_;
  Core1 core1_{*this};
};

}  // namespace armature::test
