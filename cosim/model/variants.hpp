// What the two variants of the logic do not share: the pulse generators and the decoders.
//
//   kBases       base addresses of all blocks: gpio, timer, uart, pulses, then those of edge()
//   edge()       the edge `at` of the other blocks, with the accesses and answers of kBases[4], kBases[5] ...
//   wakes_at()   the next edge that a decoder must compute, after the edge `now`
//   ik_wakes_at(), ik_irq()   of ik_cordic, if there is one; policy_wakes_at(), policy_irq() of policy_mlp
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "controller/regs/soc_map.hpp"
#include "cosim/logic/logic_spec.hpp"
#include "cosim/logic/pins.hpp"
#include "cosim/model/encoder/encoder.hpp"
#include "cosim/model/ik_cordic/ik_cordic.hpp"
#include "cosim/model/paper/encoder_switch.hpp"
#include "cosim/model/paper/pulse_width.hpp"
#include "cosim/model/policy_mlp/policy_mlp.hpp"
#include "cosim/model/pulse_train/pulse_train.hpp"
#include "cosim/model/slot.hpp"

namespace armature::cosim::model {

// What the decoders see of the other blocks.
struct DecoderInputs {
  bool trigger = false;
  std::uint8_t servo_on = 0;
};

class CountsVariant {
 public:
  using Pulses = PulseTrain;
  static constexpr bool kHasIk = true;
  static constexpr std::array kBases{regs::soc::kAxiGpioBase,    regs::soc::kAxiTimerBase, regs::soc::kAxiUart16550Base,
                                     regs::soc::kPulseTrainBase, regs::soc::kEncoderBase,  regs::soc::kIkCordicBase,
                                     regs::soc::kPolicyMlpBase};

  void edge(Cycles at, const SocInputs& pins, const DecoderInputs& in, const Strobes* access, Answer* answers) {
    answers[0] = encoder_.edge(at, inputs(pins, in), access[0]);
    answers[1] = ik_.edge(at, {}, access[1]);
    answers[2] = policy_.edge(at, {}, access[2]);
  }
  [[nodiscard]] Cycles wakes_at(Cycles now, const SocInputs& pins, const DecoderInputs& in) const {
    return encoder_.wakes_at(now, inputs(pins, in));
  }
  [[nodiscard]] Cycles ik_wakes_at() const { return ik_.block().wakes_at(); }
  [[nodiscard]] bool ik_irq() const { return ik_.block().irq(); }
  [[nodiscard]] Cycles policy_wakes_at() const { return policy_.block().wakes_at(); }
  [[nodiscard]] bool policy_irq() const { return policy_.block().irq(); }
  void stop_clock_of(ClockGroup group) {
    if (group == ClockGroup::kEncoder) encoder_.stop_gated_clock();
  }
  [[nodiscard]] Slot<Encoder<6>, EncoderInputs>& decoder() { return encoder_; }
  [[nodiscard]] Slot<IkCordic, IkInputs>& ik() { return ik_; }
  [[nodiscard]] Slot<PolicyMlp, PolicyInputs>& policy() { return policy_; }
  [[nodiscard]] Encoder<6>& encoder() { return encoder_.block(); }
  [[nodiscard]] const Encoder<6>& encoder() const { return encoder_.block(); }

 private:
  [[nodiscard]] static EncoderInputs inputs(const SocInputs& pins, const DecoderInputs& in) {
    return {.a = pins.enc_a, .b = pins.enc_b, .z = pins.enc_z, .servo_on = in.servo_on, .trigger = in.trigger};
  }

  Slot<Encoder<6>, EncoderInputs> encoder_;
  Slot<IkCordic, IkInputs> ik_;
  Slot<PolicyMlp, PolicyInputs> policy_;
};

class PaperVariant {
 public:
  using Pulses = PulseWidth;
  static constexpr bool kHasIk = false;
  static constexpr std::array kBases{regs::soc::kAxiGpioBase,      regs::soc::kAxiTimerBase,
                                     regs::soc::kAxiUart16550Base, regs::soc::kPulseWidthBase,
                                     regs::soc::kEncoderBase,      regs::soc::kEncoderSwitchBase};

  void edge(Cycles at, const SocInputs& pins, const DecoderInputs& in, const Strobes* access, Answer* answers) {
    answers[0] = decoder_.edge(at, inputs(in), access[0]);  // it sees the lines as they are before the edge
    answers[1] = switch_.edge(at, lines(pins), access[1]);
  }
  [[nodiscard]] Cycles wakes_at(Cycles now, const SocInputs& pins, const DecoderInputs& in) const {
    return std::min(decoder_.wakes_at(now, inputs(in)), switch_.wakes_at(now, lines(pins)));
  }
  [[nodiscard]] static Cycles ik_wakes_at() { return kNever; }
  [[nodiscard]] static bool ik_irq() { return false; }
  [[nodiscard]] static Cycles policy_wakes_at() { return kNever; }
  [[nodiscard]] static bool policy_irq() { return false; }
  void stop_clock_of(ClockGroup group) {
    if (group == ClockGroup::kEncoder) decoder_.stop_gated_clock();
    if (group == ClockGroup::kMotion) switch_.stop_gated_clock();
  }

 private:
  [[nodiscard]] EncoderInputs inputs(const DecoderInputs& in) const {
    const EncoderSwitch& chosen = switch_.block();
    return {.a = chosen.a(), .b = chosen.b(), .z = chosen.z(), .servo_on = in.servo_on, .trigger = in.trigger};
  }
  [[nodiscard]] static EncoderSwitchInputs lines(const SocInputs& pins) {
    return {.a = pins.enc_a, .b = pins.enc_b, .z = pins.enc_z};
  }

  Slot<Encoder<1>, EncoderInputs> decoder_;
  Slot<EncoderSwitch, EncoderSwitchInputs> switch_;
};

}  // namespace armature::cosim::model
