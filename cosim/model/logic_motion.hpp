// The motion port of the model (cosim/soc/motion_port.hpp), for the variant with six decoders.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "controller/regs/soc_map.hpp"
#include "cosim/model/logic.hpp"
#include "cosim/soc/motion_port.hpp"

namespace armature::cosim::model {

// Its cycles are edges of the logic. So no tick is whole after the clock of the logic has stood still.
class LogicMotion final : public MotionPort {
 public:
  explicit LogicMotion(Logic<CountsVariant>& logic) : logic_{logic} {}

  [[nodiscard]] DecoderTimes decoder_times() const override {
    return {.latency = encoder().latency(), .history = encoder().history()};
  }
  [[nodiscard]] std::optional<TickPulses> begin() const override {
    return std::as_const(logic_).pulses().whole_tick(logic_.now());
  }
  [[nodiscard]] bool leave_out(const LineHistory& history) override {
    if (!logic_.variant().encoder().leave_out_lines(logic_.now(), history)) return false;
    logic_.pulses().leave_out_generators(logic_.now());
    return true;
  }
  [[nodiscard]] bool expect(const PerAxis<Counts>& counts, const PerAxis<std::optional<Counts>>& index) override {
    return logic_.sleeping_variant().encoder().expect(counts, index);
  }
  void finish(const TickPulses& pulses) override { logic_.sleeping_pulses().finish_tick(pulses); }

  [[nodiscard]] bool disturbs(const BusRequest& request) const override {
    const std::uint32_t offset = word_offset(static_cast<std::uint16_t>(request.addr));
    const std::uint32_t base = request.addr - static_cast<std::uint16_t>(request.addr);
    if (base == regs::soc::kPulseTrainBase) return request.write && PulseTrain::write_disturbs(offset);
    if (base != regs::soc::kEncoderBase) return false;
    return request.write ? Encoder<6>::write_disturbs(offset) : Encoder<6>::read_disturbs(offset);
  }
  void continue_after(Cycles at, const LineHistory& history, bool begun) override {
    logic_.variant().encoder().continue_after(at, history, begun);
    logic_.pulses().run_generators(at);
    wake();
    logic_.sample_again();
  }
  [[nodiscard]] StepPins step_pins() const override {
    StepPins pins;
    for (std::size_t i = 0; i < kAxes; ++i) {
      const PulseTrain& pulses = std::as_const(logic_).pulses();
      pins.changed[i] = pulses.axis(i).changed_at();
      pins.turned[i] = pulses.axis(i).turned_at(pulses.times());
    }
    return pins;
  }
  Cycles catch_up(Cycles from, Cycles until, const EncoderLines& lines) override {
    PulseTrain& pulses = logic_.pulses();
    Encoder<6>& encoder = logic_.variant().encoder();
    const SocOutputs before = logic_.outputs();
    while (from < until && logic_.outputs() == before) {
      const Cycles line_edge = encoder.lines_wake_at(from, lines), pulse_edge = pulses.generators_wake_at();
      const Cycles next = std::min(line_edge, pulse_edge);
      from = std::min(next, until);
      if (next > until) break;
      if (line_edge == next) encoder.line_edge(next, lines);
      if (pulse_edge != next) continue;
      pulses.generator_edge(next);
      logic_.sample_again();
    }
    wake();
    return from;
  }

 private:
  void wake() {
    logic_.pulses().wake_after(logic_.now());
    logic_.variant().encoder().wake_after(logic_.now());
  }
  [[nodiscard]] const Encoder<6>& encoder() const { return std::as_const(logic_).variant().encoder(); }

  Logic<CountsVariant>& logic_;
};

}  // namespace armature::cosim::model
