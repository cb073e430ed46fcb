#include "tests/controller/support/model_logic.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "controller/regs/axi_gpio_regs.hpp"
#include "controller/regs/axi_timer_regs.hpp"
#include "controller/regs/encoder_regs.hpp"
#include "controller/regs/pulse_train_regs.hpp"
#include "tests/controller/support/block_access.hpp"

namespace armature::test {
namespace {

namespace model = cosim::model;
using Logic = model::Logic<model::CountsVariant>;

constexpr RegAddr kTcsr0 = RegAddr{regs::soc::kAxiTimerBase} + regs::axi_timer::kTcsr0Offset;
constexpr RegAddr kFault = ModelLogic::kPulses + regs::pulse_train::kFaultOffset;
constexpr Cycles kTickLength{ModelLogic::kTick};
constexpr Cycles kStep{ModelLogic::kTick / 5};  // of the drives
constexpr double kStep_s = static_cast<double>(kStep.value()) / regs::soc::kClkFreqHz;
constexpr Cycles kSettled{64};  // edges after reset until the decoders know their lines

}  // namespace

// The model, and the pulses on their way to the drives.
class ModelLogic::Chip {
 public:
  explicit Chip(ModelLogic& owner) : owner_{owner} {
    run_to(kSettled);
    const Cycles history = encoder().history();
    if (!encoder().leave_out_lines(now(), {.from = now() - history})) throw std::logic_error{"decoders do not settle"};
    wake_ = logic_.wakes_at();
  }

  [[nodiscard]] Cycles now() const { return logic_.now(); }
  [[nodiscard]] const Logic& logic() const { return logic_; }
  [[nodiscard]] std::int64_t emitted(std::size_t axis) const { return emitted_[axis]; }
  [[nodiscard]] std::int64_t largest_count() const { return largest_count_; }
  [[nodiscard]] bool timer_runs() const { return timer_runs_; }
  // Or a cycle further, if it does not begin on time. Throws std::logic_error if the timer gives no trigger.
  void run_to_next_tick() {
    run_to(std::max(tick_begins_ + kTickLength, now() + Cycles{1}));
    if (now() - tick_begins_ > Cycles{2 * kTick}) throw std::logic_error{"the timer gives no trigger"};
  }

  void run_to(Cycles end) {
    take_pins();
    while (now() < end) {
      const Cycles next = std::min({end, wake_, step_at_});
      if (next == wake_) {
        logic_.pass(next - Cycles{1});
        Logic::Answers answers;
        edge({}, answers);
      } else {
        logic_.pass(next);
      }
      if (next == step_at_) move_drives();
    }
  }

  // At the edge after `wait` more.
  std::uint32_t access(const BlockAccess& access, Cycles wait) {
    run_to(now() + wait);
    if (access.strobes.write) prepare_write(access);
    Logic::Accesses accesses;
    accesses[access.port] = access.strobes;
    Logic::Answers answers;
    edge(accesses, answers);
    if (now() == step_at_) move_drives();
    return data_of(access, answers[access.port]);
  }

  void pass_index(std::size_t axis, std::int64_t count) {
    PerAxis<std::optional<Counts>> index;
    index[axis] = Counts{count};
    if (!encoder().expect({}, index)) throw std::logic_error{"an index out of place"};
  }

 private:
  [[nodiscard]] model::PulseTrain& pulses() { return logic_.pulses(); }
  [[nodiscard]] model::Encoder<6>& encoder() { return logic_.variant().encoder(); }

  void take_pins() {
    if (owner_.pins == logic_.inputs()) return;
    if (owner_.pins.estop_n != logic_.inputs().estop_n) leave_whole_tick();
    logic_.set_inputs(owner_.pins);
    wake_ = logic_.wakes_at();
  }

  void prepare_write(const BlockAccess& access) {
    const RegAddr addr = access.addr;
    if (addr.value - kPulses.value < regs::soc::kPulseTrainSize &&
        model::PulseTrain::write_disturbs(addr.value - kPulses.value)) {
      leave_whole_tick();
    }
    if (addr == kTcsr0 && !timer_runs_ && (access.strobes.wdata & regs::axi_timer::kTcsr0EntMask) != 0) {
      timer_runs_ = true;
      tick_begins_ = now();
      // Before a restart of the software the last trigger has left the positions.
      expect_counts();
      encoder().edge(now(), {}, {.servo_on = logic_.outputs().servo_on, .trigger = true});
    }
  }

  void edge(const Logic::Accesses& accesses, Logic::Answers& answers) {
    const bool begins = logic_.outputs().trigger;
    logic_.edge(accesses, answers);
    if (!tick_) follow_step_pins();
    if (begins) begin_tick();
    if (logic_.outputs().trigger) end_tick();
    wake_ = logic_.wakes_at();
    if (begins) owner_.triggered();
  }

  // The edge of the trigger is the next one.
  void end_tick() {
    if (tick_ && tick_->ends == now() + Cycles{1}) {
      give_pulses(tick_->ends);
      pulses().finish_tick(*tick_);
    } else {
      leave_whole_tick();
    }
    tick_.reset();
    if (step_at_ != cosim::kNever) move_drives();
    step_at_ = cosim::kNever;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      largest_count_ = std::max(largest_count_, std::abs(emitted_[axis] - emitted_before_[axis]));
    }
    emitted_before_ = emitted_;
    expect_counts();
  }

  // The latest edge has seen the trigger.
  void begin_tick() {
    tick_begins_ = now();
    step_at_ = now() + kStep;
    given_ = {};
    tick_ = pulses().whole_tick(now());
    if (tick_ && tick_->ends == now() + kTickLength) {
      pulses().leave_out_generators(now());
    } else {
      tick_.reset();
      pulses().run_generators(now());
      pulses().wake_after(now());
      logic_.sample_again();
    }
    pins_before_ = logic_.outputs().step;
  }

  // Computes the edges of the tick from now on.
  void leave_whole_tick() {
    if (!tick_) return;
    give_pulses(now());
    pulses().run_generators(tick_->begins);
    while (pulses().generators_wake_at() <= now()) pulses().generator_edge(pulses().generators_wake_at());
    pulses().wake_after(now());
    logic_.sample_again();
    pins_before_ = logic_.outputs().step;
    tick_.reset();
    wake_ = logic_.wakes_at();
  }

  void give_pulses(Cycles until) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const cosim::AxisPulses& pulses = tick_->axes[axis];
      if (pulses.count == 0) continue;
      for (const std::int32_t due = pulses.rises_until(until); given_[axis] < due; ++given_[axis]) {
        give_pulse(axis, pulses.count > 0);
      }
    }
  }
  void follow_step_pins() {
    const cosim::SocOutputs& out = logic_.outputs();
    const unsigned rises = out.step & ~std::exchange(pins_before_, out.step);
    if (rises == 0) return;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if ((rises >> axis & 1u) != 0) give_pulse(axis, (out.dir >> axis & 1u) != 0);
    }
  }
  void give_pulse(std::size_t axis, bool positive) {
    const int direction = positive ? 1 : -1;
    emitted_[axis] += direction;
    owner_.drives[axis].step(direction);
  }

  // One step of a tick.
  void move_drives() {
    if (tick_) give_pulses(now());
    const unsigned servo = logic_.outputs().servo_on & ~unsigned{owner_.pins.drive_alarm};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      owner_.drives[axis].enable((servo >> axis & 1u) != 0);
      owner_.drives[axis].move(kStep_s);
    }
    step_at_ += kStep;
    if (step_at_ <= tick_begins_ + kTickLength) return;
    step_at_ = cosim::kNever;
    leave_whole_tick();  // the trigger is late
  }

  void expect_counts() {
    PerAxis<Counts> counts;
    for (std::size_t axis = 0; axis < kAxes; ++axis) counts[axis] = Counts{owner_.drives[axis].count()};
    (void)encoder().expect(counts, {});
  }

  ModelLogic& owner_;
  Logic logic_;
  Cycles wake_{1};  // the next edge of the model that must be computed
  Cycles step_at_ = cosim::kNever;
  Cycles tick_begins_{};
  bool timer_runs_ = false;
  std::optional<cosim::TickPulses> tick_;  // that runs as a whole
  PerAxis<std::int32_t> given_{};          // pulses of it that the drives have seen
  PerAxis<std::int64_t> emitted_{}, emitted_before_{};
  std::int64_t largest_count_ = 0;
  std::uint8_t pins_before_ = 0;
};

ModelLogic::ModelLogic() : chip_{std::make_unique<Chip>(*this)} {}
ModelLogic::~ModelLogic() = default;

void ModelLogic::fit_drives(const RobotModel& robot) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const AxisModel& from = robot.axes[axis];
    drives[axis].natural_rad_s = from.drive_natural_rad_s;
    drives[axis].damping = from.drive_damping;
    drives[axis].counts_per_pulse = static_cast<double>(from.counts_per_rev) / from.pulses_per_rev;
  }
}

// Its interrupt is there when the call returns.
void ModelLogic::set_tool_input(int pin, bool level) {
  constexpr std::int64_t kToInterrupt = 5;  // edges
  const auto bit = static_cast<std::uint16_t>(1u << (pin - 1));
  pins.gpio = static_cast<std::uint16_t>(level ? pins.gpio | bit : pins.gpio & ~bit);
  pass(kToInterrupt);
}

void ModelLogic::pass_index(std::size_t axis, std::int64_t count) {
  chip_->pass_index(axis, count);
}
void ModelLogic::pass(std::int64_t cycles) {
  chip_->run_to(chip_->now() + Cycles{cycles});
}
void ModelLogic::triggered() {
  const std::int64_t number = triggers_++;
  if (on_trigger) on_trigger(number);
}

const cosim::SocOutputs& ModelLogic::outputs() const {
  return chip_->logic().outputs();
}
bool ModelLogic::tool_interrupts() const {
  return (outputs().irq >> regs::soc::kAxiGpioIrq & 1u) != 0;
}
std::int64_t ModelLogic::emitted(std::size_t axis) const {
  return chip_->emitted(axis);
}
std::int64_t ModelLogic::largest_count() const {
  return chip_->largest_count();
}
std::uint32_t ModelLogic::underruns() const {
  return peek(kPulses + regs::pulse_train::kUnderrunsOffset);
}
std::uint32_t ModelLogic::peek(RegAddr addr) const {
  Logic copy = chip_->logic();
  const BlockAccess access = block_read(addr, model::CountsVariant::kBases);
  Logic::Accesses accesses;
  accesses[access.port] = access.strobes;
  Logic::Answers answers;
  copy.edge(accesses, answers);
  return data_of(access, answers[access.port]);
}

std::uint32_t ModelLogic::read(RegAddr addr, std::int64_t cycles) {
  return planted.shown(addr, chip_->access(block_read(addr, model::CountsVariant::kBases), Cycles{cycles - 1}));
}
void ModelLogic::write(RegAddr addr, std::uint32_t value, std::int64_t cycles) {
  (void)chip_->access(block_write(addr, value, model::CountsVariant::kBases), Cycles{cycles - 1});
  planted.remove(addr);
}

std::uint32_t ModelLogic::read32(RegAddr addr) noexcept {
  const std::uint32_t data = read(addr, access_cycles);
  if (addr == kFault) faults_read_ |= data;
  return data;
}
void ModelLogic::write32(RegAddr addr, std::uint32_t value) noexcept {
  write(addr, value, access_cycles);
}
Interrupts ModelLogic::wait_for_interrupt(Interrupts) noexcept {
  on_wait();
  if (!chip_->timer_runs()) return Interrupts::kNone;  // would sleep for ever
  const auto interrupts = [this] { return (outputs().irq >> regs::soc::kAxiTimerIrq & 1u) != 0; };
  while (!interrupts() && triggers_ < triggers_to_run) chip_->run_to_next_tick();
  return triggers_ < triggers_to_run ? Interrupts::kTimer : Interrupts::kNone;
}
Cycles ModelLogic::now() noexcept {
  return chip_->now() + Cycles{stood_};
}
void ModelLogic::charge(Work work, std::int64_t times) noexcept {
  pass((work == Work::kTick ? tick_cycles : work_cycles) * times);
}

}  // namespace armature::test
