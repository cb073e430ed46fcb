#include "tests/bench/tick_run.hpp"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "controller/drivers/axi_timer.hpp"
#include "controller/host_memory/boot_memory.hpp"
#include "controller/host_memory/host_side.hpp"
#include "controller/regs/encoder_regs.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "controller/regs/soc_map.hpp"
#include "tests/bench/core1_thread.hpp"
#include "tests/controller/support/model_logic.hpp"

namespace armature::bench {
namespace {

constexpr std::size_t kEvicted = std::size_t{4} << 20;  // bytes

class Notes {
 public:
  // Every page is touched before it is timed.
  explicit Notes(std::size_t ticks) : run{std::vector<TickFacts>(ticks), std::vector<MoveStarted>(64)} {
    run.moves.clear();
  }
  // After each tick, outside of what is timed. Returns whether core 1 was woken in it.
  bool read(host_memory::HostSide& host) {
    while (const std::optional<Event> event = host.next_event()) add(*event);
    if (const std::optional<Telemetry> telemetry = host.new_telemetry(); telemetry) {
      TickFacts& tick = run.ticks[static_cast<std::size_t>(telemetry->tick.value())];
      tick.state = telemetry->state;
      tick.rate = telemetry->rate;
    }
    if (host.lost_events() != 0) disturbed = true;
    return std::exchange(core1_woken_, false);
  }
  // Core 0 sends core 1 an interrupt.
  void core1_woken() { core1_woken_ = true; }
  void add(const Event& event) {
    if (const auto* move = std::get_if<MoveStarted>(&event)) {
      run.moves.push_back(*move);
    } else if (std::holds_alternative<MoveFinished>(event)) {
      ++moves_finished;
    } else {
      disturbed = true;
    }
  }

  TickRun run;
  std::int64_t moves_finished = 0;
  bool disturbed = false;

 private:
  bool core1_woken_ = false;
};

// The model of the logic as core 0's register bus, and the time of each tick.
//
// Nothing that core 0 does computes an edge of the model while it is timed: an access is one load or store. What the
// registers of a tick show is read before the tick, and what core 0 writes reaches the model when it waits. What the
// logic and the drives do, and what `between` does, happens then, too. The time of a tick is from the end of a wait to
// the next one.
class TimedLogic final : public RegisterBus {
 public:
  // Runs for so many ticks, then switches the core off. Calls `between` after each trigger with its number, from 0.
  TimedLogic(const RobotModel& robot, std::size_t ticks, std::function<void(std::size_t)> between)
      : between_{std::move(between)}, ticks_{ticks} {
    tick_ns.reserve(ticks);
    logic.fit_drives(robot);
    logic.access_cycles = 1;
    logic.triggers_to_run = static_cast<std::int64_t>(ticks) + 1;
    logic.on_trigger = [this](std::int64_t trigger) {
      if (static_cast<std::size_t>(trigger) < ticks_) between_(static_cast<std::size_t>(trigger));
    };
  }
  test::ModelLogic logic;
  std::vector<double> tick_ns;

  std::uint32_t read32(RegAddr addr) noexcept override {
    if (reads_ < shown_.size() && shown_[reads_].addr == addr) return shown_[reads_++].value;
    write_all();
    return logic.read32(addr);
  }
  void write32(RegAddr addr, std::uint32_t value) noexcept override {
    if (writes_ == written_.size()) write_all();
    written_[writes_++] = {addr, value};
  }
  Interrupts wait_for_interrupt(Interrupts mask) noexcept override {
    const Clock::time_point slept = Clock::now();
    if (logic.triggers() > 0) tick_ns.push_back(std::chrono::duration<double, std::nano>(slept - woken_).count());
    write_all();
    const Interrupts interrupts = logic.wait_for_interrupt(mask);
    for (Register& shown : shown_) shown.value = logic.read32(shown.addr);
    reads_ = 0;
    woken_ = Clock::now();
    return interrupts;
  }
  void send_event() noexcept override { logic.send_event(); }
  Cycles now() noexcept override { return logic.now(); }
  void charge(Work, std::int64_t) noexcept override {}

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr RegAddr kPulses{regs::soc::kPulseTrainBase}, kEncoder{regs::soc::kEncoderBase};
  struct Register {
    RegAddr addr;
    std::uint32_t value;
  };

  void write_all() {
    for (std::size_t i = 0; i < writes_; ++i) logic.write32(written_[i].addr, written_[i].value);
    writes_ = 0;
  }

  // In the order in which a tick reads them.
  static constexpr std::array<std::uint32_t, 4> kOfPulses{
      regs::pulse_train::kFaultOffset, regs::pulse_train::kStatusOffset, regs::pulse_train::kSwitchesOffset,
      regs::pulse_train::kDrivesOffset};
  static constexpr auto kShown = [] {
    std::array<Register, kOfPulses.size() + 1 + kAxes> shown{};
    std::size_t next = 0;
    for (const std::uint32_t offset : kOfPulses) shown[next++].addr = kPulses + offset;
    shown[next++].addr = kEncoder + regs::encoder::kFaultOffset;
    for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
      shown[next++].addr = kEncoder + (regs::encoder::kPositionOffset + axis * regs::encoder::kPositionStride);
    }
    return shown;
  }();

  std::function<void(std::size_t)> between_;
  std::size_t ticks_;
  Clock::time_point woken_;
  std::array<Register, kShown.size()> shown_{kShown};
  std::size_t reads_ = kShown.size();  // of shown_ in this tick; before the first one the model is read
  std::array<Register, 64> written_{};
  std::size_t writes_ = 0;
};

void access_only(RegisterBus& bus) {
  using namespace regs;
  constexpr RegAddr kPulses{soc::kPulseTrainBase}, kEncoder{soc::kEncoderBase};
  AxiTimer timer{bus};
  timer.start(Cycles{soc::kTickCycles});
  std::uint32_t sequence = 0;
  while (bus.wait_for_interrupt(Interrupts::kTimer) != Interrupts::kNone) {
    bus.charge(Work::kInterruptEntry);
    timer.acknowledge();
    std::uint32_t sum = 0;
    for (const std::uint32_t offset : {pulse_train::kFaultOffset, pulse_train::kStatusOffset,
                                       pulse_train::kSwitchesOffset, pulse_train::kDrivesOffset}) {
      sum += bus.read32(kPulses + offset);
    }
    sum += bus.read32(kEncoder + encoder::kFaultOffset);
    for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
      sum += bus.read32(kEncoder + (encoder::kPositionOffset + axis * encoder::kPositionStride));
    }
    bus.charge(Work::kTick);
    for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
      bus.write32(kPulses + (pulse_train::kCountOffset + axis * pulse_train::kCountStride), sum & 0u);
    }
    bus.write32(kPulses + pulse_train::kCommitOffset, ++sequence);
  }
}

void evict_caches() {
  constexpr std::size_t kWordsPerLine = 8;
  static std::vector<std::uint64_t> other(kEvicted / sizeof(std::uint64_t), 1);
  for (std::size_t i = 0; i < other.size(); i += kWordsPerLine) ++other[i];
}

}  // namespace

TickRun run(const TickScript& script) {
  Notes notes{script.ticks};
  host_memory::BootMemory memory{script.robot, {.flange_T_tool = script.flange_T_tool, .base_T_user = {}}};
  host_memory::HostSide host{memory.memory()};
  const auto controller = std::make_unique<Controller>(memory.memory());
  Core1Thread core1{*controller};
  auto next = script.commands.begin();
  auto program = script.program.begin();
  std::size_t moves = 0;
  TimedLogic plant{script.robot, script.ticks, [&](std::size_t trigger) {
                     bool called = notes.read(host);
                     for (; next != script.commands.end() && next->first == trigger; ++next) {
                       if (!host.submit(Source::kScenario, next->second)) notes.disturbed = true;
                       if (next->second.index() <= 2) ++moves;  // JointMove, PoseMove, CartesianMove
                       called = true;
                     }
                     const bool there = next == script.commands.end();
                     while (there && program != script.program.end() && host.submit(Source::kProgram, *program)) {
                       ++program;
                       ++moves;
                       called = true;
                     }
                     core1.advance(Cycles{static_cast<std::int64_t>(trigger) * regs::soc::kTickCycles}, called);
                     (void)notes.read(host);
                     if (script.cold) evict_caches();
                   }};
  plant.logic.on_event = [&notes] { notes.core1_woken(); };
  controller->core0_main(plant);
  (void)notes.read(host);
  if (notes.disturbed || plant.logic.underruns() != 0 || notes.moves_finished != static_cast<std::int64_t>(moves)) {
    throw std::logic_error{fmt::format("a run did not go as planned: {} of {} moves finished, {} underruns{}",
                                       notes.moves_finished, moves, plant.logic.underruns(),
                                       notes.disturbed ? ", a refusal or a fault" : "")};
  }
  for (std::size_t i = 0; i < script.ticks; ++i) notes.run.ticks[i].ns = plant.tick_ns[i];
  return std::move(notes.run);
}

std::vector<double> bus_alone_ns(std::size_t ticks) {
  RobotModel robot;
  for (AxisModel& axis : robot.axes) axis.drive_natural_rad_s = 250.0;
  TimedLogic plant{robot, ticks, [](std::size_t) {}};
  access_only(plant);
  return plant.tick_ns;
}

}  // namespace armature::bench
