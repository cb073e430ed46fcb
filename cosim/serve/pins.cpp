#include "cosim/serve/pins.hpp"

#include <algorithm>

#include "controller/core/axes.hpp"
#include "controller/regs/soc_map.hpp"

namespace armature::cosim {
namespace {

constexpr int kAxisBits = static_cast<int>(kAxes);
constexpr int kIrqBits = static_cast<int>(regs::soc::kNumIrqs);
constexpr int kGpioBits = 16;

template <auto Level>
constexpr Pin in(std::string_view name, int bits = 1) {
  return {name, bits, [](const FabricInputs& inputs, const FabricOutputs&) { return std::uint32_t{inputs.*Level}; },
          [](FabricInputs& inputs, std::uint32_t value) {
            auto& level = inputs.*Level;
            level = static_cast<std::remove_reference_t<decltype(level)>>(value);
          }};
}

template <auto Level>
constexpr Pin out(std::string_view name, int bits = 1) {
  return {name, bits, [](const FabricInputs&, const FabricOutputs& outputs) { return std::uint32_t{outputs.*Level}; },
          nullptr};
}

using In = FabricInputs;
using Out = FabricOutputs;

constexpr Pin kPins[] = {
    out<&Out::step>("step_o", kAxisBits),
    out<&Out::dir>("dir_o", kAxisBits),
    out<&Out::servo_on>("servo_on_o", kAxisBits),
    in<&In::drive_alarm>("drive_alarm_i", kAxisBits),
    in<&In::in_position>("in_position_i", kAxisBits),
    in<&In::enc_a>("enc_a_i", kAxisBits),
    in<&In::enc_b>("enc_b_i", kAxisBits),
    in<&In::enc_z>("enc_z_i", kAxisBits),
    in<&In::home>("home_i", kAxisBits),
    in<&In::limit_pos>("limit_pos_i", kAxisBits),
    in<&In::limit_neg>("limit_neg_i", kAxisBits),
    in<&In::estop_n>("estop_ni"),
    in<&In::uart_rxd>("uart_rxd_i"),
    out<&Out::uart_txd>("uart_txd_o"),
    in<&In::gpio>("gpio_i", kGpioBits),
    out<&Out::gpio>("gpio_o", kGpioBits),
    in<&In::capture_trig>("capture_trig_i"),
    out<&Out::pwm>("pwm_o"),
    out<&Out::trigger>("trigger_o"),
    out<&Out::irq>("irq_o", kIrqBits),
};

}  // namespace

std::span<const Pin> pins() {
  return kPins;
}

const Pin* find_pin(std::string_view name) {
  const auto found = std::ranges::find(kPins, name, &Pin::name);
  return found == std::end(kPins) ? nullptr : &*found;
}

}  // namespace armature::cosim
