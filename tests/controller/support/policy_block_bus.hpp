// A bus with nothing but the model of policy_mlp.
#pragma once

#include <cstdint>

#include "controller/hal/register_bus.hpp"
#include "cosim/model/policy_mlp/policy_mlp.hpp"

namespace armature::test {

// The block alone, an edge per access; accesses to other addresses read 0.
class PolicyBlockBus final : public RegisterBus {
 public:
  std::uint32_t read32(RegAddr addr) noexcept override {
    return edge({.read = true, .raddr = static_cast<std::uint16_t>(addr.value)}).rdata;
  }
  void write32(RegAddr addr, std::uint32_t value) noexcept override {
    edge({.write = true, .waddr = static_cast<std::uint16_t>(addr.value), .wdata = value, .wstrb = 0xF});
    edge({});
  }
  Interrupts wait_for_interrupt(Interrupts /*mask*/) noexcept override { return Interrupts::kNone; }
  void send_event() noexcept override {}
  Cycles now() noexcept override { return now_; }
  void charge(Work /*work*/, std::int64_t /*times*/) noexcept override {}

  void pass(std::int64_t clocks) {
    for (std::int64_t i = 0; i < clocks; ++i) edge({});
  }

 private:
  cosim::model::Answer edge(const cosim::model::Strobes& access) {
    now_ += Cycles{1};
    return block_.edge(now_, access, {});
  }

  cosim::model::PolicyMlp block_;
  Cycles now_{};
};

}  // namespace armature::test
