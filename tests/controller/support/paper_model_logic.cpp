#include "tests/controller/support/paper_model_logic.hpp"

#include <algorithm>
#include <utility>

#include "controller/regs/axi_timer_regs.hpp"
#include "controller/regs/encoder_switch_regs.hpp"
#include "controller/regs/pulse_width_regs.hpp"
#include "tests/controller/support/block_access.hpp"

namespace armature::test {
namespace {

namespace model = cosim::model;
using PaperLogic = model::Logic<model::PaperVariant>;

constexpr auto& kBases = model::PaperVariant::kBases;
constexpr RegAddr kTimerControl = RegAddr{regs::soc::kAxiTimerBase} + regs::axi_timer::kTcsr0Offset;
constexpr Cycles kPaperTick{regs::soc::kTickCycles};
constexpr Cycles kDirTime{25};
constexpr Cycles kKnown{64};  // edges after reset until the decoder knows its lines

constexpr bool is_set(std::uint8_t bits, std::size_t axis) {
  return (bits >> axis & 1u) != 0;
}

}  // namespace

class PaperModelLogic::Chip {
 public:
  explicit Chip(PaperModelLogic& owner) : owner_{owner} { run_to(kKnown); }

  [[nodiscard]] const PaperLogic& logic() const { return logic_; }
  [[nodiscard]] Cycles now() const { return logic_.now(); }
  [[nodiscard]] const PerAxis<std::int64_t>& emitted() const { return emitted_; }
  [[nodiscard]] std::int64_t last_tick(std::size_t axis) const { return at_trigger_[axis] - before_[axis]; }
  [[nodiscard]] Cycles next_tick() const { return std::max(tick_begins_ + kPaperTick, now() + Cycles{1}); }

  void run_to(Cycles end) {
    set_pins();
    while (now() < end) {
      const Cycles next = logic_.wakes_at();
      if (next > end) return logic_.pass(end);
      logic_.pass(next - Cycles{1});
      PaperLogic::Answers answers;
      edge({}, answers);
    }
  }
  std::uint32_t access(const BlockAccess& access) {
    set_pins();
    const bool starts = access.addr == kTimerControl && (access.strobes.wdata & regs::axi_timer::kTcsr0EntMask) != 0;
    if (starts && tick_begins_ == Cycles{}) tick_begins_ = now();
    PaperLogic::Accesses accesses;
    accesses[access.port] = access.strobes;
    PaperLogic::Answers answers;
    edge(accesses, answers);
    return data_of(access, answers[access.port]);
  }

 private:
  void edge(const PaperLogic::Accesses& accesses, PaperLogic::Answers& answers) {
    const cosim::SocOutputs before = logic_.outputs();
    logic_.edge(accesses, answers);
    const cosim::SocOutputs& out = logic_.outputs();
    if (before.trigger) {
      tick_begins_ = now();
      before_ = std::exchange(at_trigger_, emitted_);
    }
    if (before.step == out.step && before.dir == out.dir) return;
    for (std::size_t axis = 0; axis < kAxes; ++axis) follow(axis, before, out);
    set_pins();
  }

  // The pins of an axis after an edge.
  void follow(std::size_t axis, const cosim::SocOutputs& before, const cosim::SocOutputs& out) {
    const bool was_high = is_set(before.step, axis), high = is_set(out.step, axis);
    const bool positive = is_set(out.dir, axis);
    if (was_high && !high) fell_[axis] = now();
    if (positive != is_set(before.dir, axis)) {
      if (high) breach(axis, "step is high");
      if (fell_[axis] != Cycles{} && now() - fell_[axis] < kDirTime) breach(axis, "hold too short");
      turned_[axis] = now();
    }
    if (was_high || !high) return;
    if (turned_[axis] != Cycles{} && now() - turned_[axis] < kDirTime) breach(axis, "set-up too short");
    emitted_[axis] += positive ? 1 : -1;
  }
  void breach(std::size_t axis, const char* what) {
    owner_.breaches.push_back("axis " + std::to_string(axis + 1) + " turns at cycle " + std::to_string(now().value()) +
                              ": " + what);
  }

  // Vo 2021, Table 1: counts up while A leads B.
  void set_pins() {
    cosim::SocInputs pins = logic_.inputs();
    pins.estop_n = !owner_.estop_pin;
    if (owner_.has_encoders) {
      pins.enc_a = pins.enc_b = 0;
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const std::int64_t phase = (owner_.offsets[axis] + emitted_[axis]) & 3;
        const std::uint8_t bit = static_cast<std::uint8_t>(1u << axis);
        if (phase == 1 || phase == 2) pins.enc_a |= bit;
        if (phase >= 2) pins.enc_b |= bit;
      }
    }
    logic_.set_inputs(pins);
  }

  PaperModelLogic& owner_;
  PaperLogic logic_;
  Cycles tick_begins_{};  // or the start of the timer
  PerAxis<std::int64_t> emitted_{}, at_trigger_{}, before_{};
  PerAxis<Cycles> fell_{}, turned_{};
};

PaperModelLogic::PaperModelLogic() : chip_{std::make_unique<Chip>(*this)} {}
PaperModelLogic::~PaperModelLogic() = default;

void PaperModelLogic::pass(std::int64_t cycles) {
  chip_->run_to(chip_->now() + Cycles{cycles});
}
std::int64_t PaperModelLogic::cycles_to_trigger() const {
  return (chip_->next_tick() - chip_->now()).value();
}
const PerAxis<std::int64_t>& PaperModelLogic::emitted() const {
  return chip_->emitted();
}
std::int64_t PaperModelLogic::last_tick(std::size_t axis) const {
  return chip_->last_tick(axis);
}
std::int64_t PaperModelLogic::width(std::size_t axis) {
  return static_cast<std::int32_t>(chip_->access(
      block_read(kPulses + (regs::pulse_width::kWidthOffset + 4 * static_cast<std::uint32_t>(axis)), kBases)));
}
std::uint32_t PaperModelLogic::selected() {
  return chip_->access(block_read(kSwitch + regs::encoder_switch::kSelectOffset, kBases));
}
std::uint32_t PaperModelLogic::servo_on() const {
  return chip_->logic().outputs().servo_on;
}

std::uint32_t PaperModelLogic::read32(RegAddr addr) noexcept {
  pass(kAccessCycles - 1);
  return planted.shown(addr, chip_->access(block_read(addr, kBases)));
}
void PaperModelLogic::write32(RegAddr addr, std::uint32_t value) noexcept {
  pass(kAccessCycles - 1);
  (void)chip_->access(block_write(addr, value, kBases));
  planted.remove(addr);
}
Cycles PaperModelLogic::now() noexcept {
  return chip_->now();
}

}  // namespace armature::test
