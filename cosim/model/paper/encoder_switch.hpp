// Model of the block encoder_switch: the lines of one of six encoders, one edge later (rtl/REGISTERS.md).
#pragma once

#include <cstdint>

#include "controller/regs/encoder_switch_regs.hpp"
#include "cosim/model/block.hpp"

namespace armature::cosim::model {

// Levels before an edge. One bit per axis, axis 1 is bit 0.
struct EncoderSwitchInputs {
  std::uint8_t a = 0, b = 0, z = 0;

  friend bool operator==(const EncoderSwitchInputs&, const EncoderSwitchInputs&) = default;
};

class EncoderSwitch {
 public:
  Answer edge(Cycles at, const Strobes& access, const EncoderSwitchInputs& in) {
    namespace regs = armature::regs::encoder_switch;
    Answer answer;
    if (access.read && !gated_clock_stopped_) answer = read(word_offset(access.raddr));
    const auto selected = [this](std::uint8_t lines) { return select_ < 6 && (lines >> select_ & 1u) != 0; };
    a_ = selected(in.a);
    b_ = selected(in.b);
    z_ = selected(in.z);
    wakes_at_ = kNever;
    if (access.write && !gated_clock_stopped_) {
      answer.werr = word_offset(access.waddr) != regs::kSelectOffset;
      if (!answer.werr) select_ = merged(select_, access) & regs::kSelectAxisMask;
      wakes_at_ = at + Cycles{1};  // the lines of another encoder
    }
    return answer;
  }
  [[nodiscard]] Cycles wakes_at() const { return wakes_at_; }

  [[nodiscard]] bool a() const { return a_; }
  [[nodiscard]] bool b() const { return b_; }
  [[nodiscard]] bool z() const { return z_; }

  // The clock of the registers stands still from now on.
  void stop_gated_clock() { gated_clock_stopped_ = true; }

 private:
  [[nodiscard]] Answer read(std::uint32_t offset) const {
    namespace regs = armature::regs::encoder_switch;
    if (offset == regs::kIdOffset) return {.rdata = regs::kIdWord};
    if (offset == regs::kSelectOffset) return {.rdata = select_};
    return kUnmappedRead;
  }

  std::uint32_t select_ = 0;
  bool a_ = false, b_ = false, z_ = false;
  Cycles wakes_at_ = Cycles{1};
  bool gated_clock_stopped_ = false;
};

}  // namespace armature::cosim::model
