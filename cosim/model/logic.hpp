// All blocks of a variant with their connections, without the bus: register accesses come as strobes of single edges.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>

#include "controller/regs/soc_map.hpp"
#include "cosim/bus/bus_access.hpp"
#include "cosim/logic/logic_spec.hpp"
#include "cosim/logic/pins.hpp"
#include "cosim/model/block.hpp"
#include "cosim/model/gpio/axi_gpio.hpp"
#include "cosim/model/slot.hpp"
#include "cosim/model/timer/axi_timer.hpp"
#include "cosim/model/uart/axi_uart16550.hpp"
#include "cosim/model/variants.hpp"

namespace armature::cosim::model {

// Variant: CountsVariant or PaperVariant.
template <class Variant>
class Logic {
 public:
  static constexpr std::size_t kBlocks = Variant::kBases.size();
  using Accesses = std::array<Strobes, kBlocks>;  // by port of the crossbar, as kBases
  using Answers = std::array<Answer, kBlocks>;

  Logic() { show_outputs(kAllPorts); }

  void set_inputs(const SocInputs& inputs) {
    in_ = inputs;
    wakes_known_ = false;
  }
  [[nodiscard]] const SocInputs& inputs() const { return in_; }
  [[nodiscard]] const SocOutputs& outputs() const { return outputs_; }
  [[nodiscard]] Cycles now() const { return now_; }  // the latest edge

  // The next edge that must be computed if it has no access.
  [[nodiscard]] Cycles wakes_at() const {
    if (!wakes_known_) find_wakes();
    return next_wake_;
  }

  // Edges up to `until` that need not be computed. Throws std::logic_error when time would go back.
  void pass(Cycles until) {
    if (until < now_) throw_past();
    now_ = until;
  }

  // The next edge. Returns whether an output has changed.
  bool edge(const Accesses& access, Answers& answers) {
    now_ += Cycles{1};
    // All levels before the edge.
    const PulseInputs pulses = pulse_inputs();
    const DecoderInputs decoder = decoder_inputs();
    answers[0] = gpio_.edge(now_, gpio_inputs(), access[0]);
    answers[1] = timer_.edge(now_, timer_inputs(), access[1]);
    answers[2] = uart_.edge(now_, uart_inputs(), access[2]);
    answers[3] = pulses_.edge(now_, pulses, access[3]);
    variant_.edge(now_, in_, decoder, &access[4], &answers[4]);
    wakes_known_ = false;
    return show_outputs(kAllPorts);
  }

  // The next edge, without an access: only blocks that must be computed are.
  bool edge() {
    if (!wakes_known_) find_wakes();
    now_ += Cycles{1};
    std::uint32_t due = 0;
    const auto is_due = [&](std::size_t port) {
      const bool is = wakes_[port] <= now_;
      due |= static_cast<std::uint32_t>(is) << port;
      return is;
    };
    const bool gpio = is_due(0), timer = is_due(1), uart = is_due(2), generators = is_due(3), decoders = is_due(4),
               kinematics = is_due(5), policy = is_due(6);
    // All inputs are levels before the edge: outputs_ changes after it.
    if (gpio) gpio_.edge(now_, gpio_inputs(), {});
    if (timer) timer_.edge(now_, timer_inputs(), {});
    if (uart) uart_.edge(now_, uart_inputs(), {});
    if (generators) pulses_.edge(now_, pulse_inputs(), {});
    if (decoders || kinematics || policy) {
      const std::array<Strobes, kBlocks - 4> none;
      std::array<Answer, kBlocks - 4> answers;
      variant_.edge(now_, in_, decoder_inputs(), none.data(), answers.data());
    }
    const bool changed = show_outputs(due);
    if (gpio) wakes_[0] = gpio_.wakes_at(now_, gpio_inputs());
    if (timer) wakes_[1] = timer_.wakes_at(now_, timer_inputs());
    if (uart) wakes_[2] = uart_.wakes_at(now_, uart_inputs());
    // Outputs are inputs of these.
    if (generators || changed) wakes_[3] = pulses_.wakes_at(now_, pulse_inputs());
    if (decoders || changed) wakes_[4] = variant_.wakes_at(now_, in_, decoder_inputs());
    if (kinematics) wakes_[5] = variant_.ik_wakes_at();
    if (policy) wakes_[6] = variant_.policy_wakes_at();
    next_wake_ = std::ranges::min(wakes_);
    return changed;
  }

  // The next edge, with an access at this port only.
  bool edge(std::size_t port, const Strobes& access, Answer& answer) {
    const Cycles next = now_ + Cycles{1};
    return wakes_at() > next ? this->access(port, next, access, answer) : edge_of_all(port, access, answer);
  }

  // The edge `at`, before wakes_at(), with an access at this port only. So frequent that a call would cost as much.
  [[gnu::always_inline]] bool access(std::size_t port, Cycles at, const Strobes& access, Answer& answer) {
    pass(at - Cycles{1});
    if (port >= kQuickPorts) return edge_of_all(port, access, answer);
    now_ = at;
    const auto of = [&](auto& slot) __attribute__((always_inline)) {
      answer = slot.access(now_, access);
      const Cycles before = std::exchange(wakes_[port], slot.block().wakes_at());
      if (wakes_[port] != before) next_wake_ = std::ranges::min(wakes_);
    };
    bool shows = access.write;
    switch (port) {
      case 0:
        of(gpio_);
        break;
      case 1:
        of(timer_);
        break;
      case 2:
        of(uart_);
        shows = true;  // a read of the received byte ends an interrupt
        break;
      case 3:
        of(pulses_);
        shows = shows && decltype(pulses_)::kAccessShows;
        break;
      case 4:
        if constexpr (kQuickPorts > 4) of(variant_.decoder());
        return false;  // it has no output
      default:
        if constexpr (Variant::kHasIk) port == 5 ? of(variant_.ik()) : of(variant_.policy());
        return false;  // its interrupt follows at the next edge
    }
    if (!shows || !show_outputs(1u << port)) return false;
    wakes_known_ = false;
    return true;
  }

  // An access at the edge `at`, before wakes_at(), that changes no output and no coming edge (block.hpp). Returns the
  // data of a read, 0 of a write; nothing, and does nothing, if it may be another one.
  [[gnu::always_inline]] std::optional<std::uint32_t> access_unnoticed(const BusRequest& request, Cycles at) {
    if constexpr (Variant::kHasIk) {
      const std::uint32_t offset = word_offset(static_cast<std::uint16_t>(request.addr));
      const std::uint32_t base = request.addr - static_cast<std::uint16_t>(request.addr);
      if (request.write) {
        const bool staged = base == Variant::kBases[3] && pulses_.block().stage(offset, request.data, request.strobes);
        return staged ? std::optional{0u} : std::nullopt;
      }
      if (base == Variant::kBases[4]) return variant_.encoder().peek(offset);
      return peek(base, at, offset);
    }
    return std::nullopt;
  }

  void stop_clock_of(ClockGroup group) {
    wakes_known_ = false;
    if (group == ClockGroup::kIo) {
      gpio_.stop_gated_clock();
      uart_.stop_gated_clock();
    } else if (group == ClockGroup::kMotion) {
      timer_.stop_gated_clock();
      pulses_.stop_gated_clock();
    }
    variant_.stop_clock_of(group);
  }

  // ---- whole ticks, with the blocks of CountsVariant (motion_port.hpp). Cycles are edges of the logic.
  [[nodiscard]] typename Variant::Pulses& pulses() {
    wakes_known_ = false;
    return pulses_.block();
  }
  [[nodiscard]] const typename Variant::Pulses& pulses() const { return pulses_.block(); }
  // The same blocks for what changes no edge that they must compute.
  [[nodiscard]] typename Variant::Pulses& sleeping_pulses() { return pulses_.block(); }
  [[nodiscard]] Variant& sleeping_variant() { return variant_; }
  [[nodiscard]] Variant& variant() {
    wakes_known_ = false;
    return variant_;
  }
  [[nodiscard]] const Variant& variant() const { return variant_; }
  // The outputs after edges of the pulses that were computed late.
  void sample_again() { show_outputs(kAllPorts); }

  // The ports of the blocks that have the gated clock of `group`, one bit each.
  [[nodiscard]] static constexpr std::uint32_t ports_of(ClockGroup group) {
    constexpr std::uint32_t kSwitch = Variant::kHasIk ? 0u : 1u << 5;
    return group == ClockGroup::kIo ? 0b101u : group == ClockGroup::kMotion ? 0b1010u | kSwitch : 0b10000u;
  }

 private:
  [[gnu::noinline]] std::optional<std::uint32_t> peek(std::uint32_t base, Cycles at, std::uint32_t offset) const {
    if (base == Variant::kBases[3]) return pulses_.block().peek(at, offset);
    return base == Variant::kBases[0] ? gpio_.block().peek(offset) : std::nullopt;
  }

  static constexpr std::uint32_t kAllPorts = (1u << kBlocks) - 1;
  // The blocks behind these ports can have an edge alone; those of the paper's decoder cannot.
  static constexpr std::size_t kQuickPorts = Variant::kHasIk ? kBlocks : 4;

  [[noreturn]] static void throw_past() { throw std::logic_error{"model: a block asks for an edge in the past"}; }

  [[nodiscard]] GpioInputs gpio_inputs() const { return {.gpio1 = in_.gpio1, .gpio2 = in_.gpio}; }
  [[nodiscard]] TimerInputs timer_inputs() const { return {.capture_trig = in_.capture_trig}; }
  [[nodiscard]] UartInputs uart_inputs() const {
    return {.rxd = in_.uart_rxd,
            .cts_n = in_.uart_cts_n,
            .dsr_n = in_.uart_dsr_n,
            .dcd_n = in_.uart_dcd_n,
            .ri_n = in_.uart_ri_n};
  }
  [[nodiscard]] PulseInputs pulse_inputs() const {
    return {.trigger = outputs_.trigger,
            .estop_n = in_.estop_n,
            .home = in_.home,
            .limit_pos = in_.limit_pos,
            .limit_neg = in_.limit_neg,
            .drive_alarm = in_.drive_alarm,
            .in_position = in_.in_position};
  }
  [[nodiscard]] DecoderInputs decoder_inputs() const {
    return {.trigger = outputs_.trigger, .servo_on = outputs_.servo_on};
  }

  void find_wakes() const {
    wakes_ = {gpio_.wakes_at(now_, gpio_inputs()),
              timer_.wakes_at(now_, timer_inputs()),
              uart_.wakes_at(now_, uart_inputs()),
              pulses_.wakes_at(now_, pulse_inputs()),
              variant_.wakes_at(now_, in_, decoder_inputs()),
              variant_.ik_wakes_at(),
              variant_.policy_wakes_at()};
    next_wake_ = std::ranges::min(wakes_);
    wakes_known_ = true;
  }

  bool edge_of_all(std::size_t port, const Strobes& access, Answer& answer) {
    Accesses accesses;
    Answers answers;
    accesses[port] = access;
    const bool changed = edge(accesses, answers);
    answer = answers[port];
    return changed;
  }

  // The outputs of the blocks behind these ports, one bit each. Returns whether an output has changed.
  bool show_outputs(std::uint32_t ports) {
    bool changed = false;
    const auto show = [&changed](auto& pin, auto level) {
      changed |= pin != level;
      pin = level;
    };
    if ((ports & 1u) != 0) show(outputs_.gpio, gpio_.block().driven());
    if ((ports & 2u) != 0) {
      show(outputs_.pwm, timer_.block().pwm());
      show(outputs_.trigger, timer_.block().trigger());
    }
    if ((ports & 4u) != 0) {
      show(outputs_.uart_txd, uart_.block().txd());
      show(outputs_.uart_rts_n, uart_.block().rts_n());
      show(outputs_.uart_dtr_n, uart_.block().dtr_n());
    }
    if ((ports & 8u) != 0) {
      const auto& pulses = pulses_.block();
      show(outputs_.step, pulses.step());
      show(outputs_.dir, pulses.dir());
      show(outputs_.servo_on, pulses.servo_on());
      show(outputs_.heartbeat, pulses.heartbeat());
    }
    const auto irq = [](bool level, std::uint32_t line) { return (level ? 1u : 0u) << line; };
    show(outputs_.irq, static_cast<std::uint8_t>(irq(gpio_.block().irq(), regs::soc::kAxiGpioIrq) |
                                                 irq(timer_.block().irq(), regs::soc::kAxiTimerIrq) |
                                                 irq(uart_.block().irq(), regs::soc::kAxiUart16550Irq) |
                                                 irq(variant_.ik_irq(), regs::soc::kIkCordicIrq) |
                                                 irq(variant_.policy_irq(), regs::soc::kPolicyMlpIrq)));
    return changed;
  }

  SocInputs in_;
  Slot<AxiGpio, GpioInputs> gpio_;
  Slot<AxiTimer, TimerInputs> timer_;
  Slot<AxiUart16550, UartInputs> uart_;
  Slot<typename Variant::Pulses, PulseInputs> pulses_;
  Variant variant_;
  SocOutputs outputs_;
  Cycles now_{};
  // The next edges that the blocks must compute, by port; [4] is of all decoders, [5] of ik_cordic, [6] of policy_mlp.
  mutable std::array<Cycles, 7> wakes_{};
  mutable Cycles next_wake_{};  // the earliest of them
  mutable bool wakes_known_ = false;
};

}  // namespace armature::cosim::model
