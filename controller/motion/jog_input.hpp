// The jog commands of core 1 as the input of a velocity source, on core 0.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/motion/mailbox.hpp"
#include "controller/motion/velocity_input.hpp"

namespace armature {

class JogInput final : public VelocityInput {
 public:
  // The mailbox must outlive the input.
  explicit JogInput(MotionMailbox& mailbox) noexcept : mailbox_{mailbox} {}

  [[nodiscard]] std::optional<VelocityCommand> latest() noexcept override {
    std::optional<VelocityCommand> latest;
    while (const std::optional<VelocityCommand> next = mailbox_.jogs.try_pop()) {
      ++mailbox_.jogs_accepted;
      if (!latest || latest->kind < VelocityCommand::Kind::kHalt || next->kind > latest->kind) latest = next;
    }
    return latest;
  }

 private:
  MotionMailbox& mailbox_;
};

}  // namespace armature
