// The clocks of a verilated arm_soc. Model: a class that Verilator has generated.
//
// In reset a gated clock needs every edge, afterwards only the edges before which its bit of active_o is 1. The other
// edges change no flop (proved in tests/formal), and a block without an edge costs no time.
#pragma once

namespace armature::cosim {

// The bits of active_o.
inline constexpr unsigned kIoClock = 1, kMotionClock = 2, kEncoderClock = 4, kBusClock = 8, kIkClock = 16,
                          kPolicyClock = 32;
inline constexpr unsigned kAllGatedClocks =
    kIoClock | kMotionClock | kEncoderClock | kBusClock | kIkClock | kPolicyClock;

// The clocks that rise together.
struct Clocks {
  bool ungated = false;  // clk_i
  unsigned gated = 0;    // bits of active_o

  // By the names of the pins.
  [[nodiscard]] bool clk_i() const { return ungated; }
  [[nodiscard]] bool clk_io_i() const { return (gated & kIoClock) != 0; }
  [[nodiscard]] bool clk_motion_i() const { return (gated & kMotionClock) != 0; }
  [[nodiscard]] bool clk_encoder_i() const { return (gated & kEncoderClock) != 0; }
  [[nodiscard]] bool clk_bus_i() const { return (gated & kBusClock) != 0; }
  [[nodiscard]] bool clk_ik_i() const { return (gated & kIkClock) != 0; }
  [[nodiscard]] bool clk_policy_i() const { return (gated & kPolicyClock) != 0; }
};

// The gated clocks that the levels of input pins need, besides active_o. That depends on flops only, so it does not see
// a request that the master has just begun.
template <class Model>
[[nodiscard]] unsigned requested_clocks(const Model& model) {
  const bool request = (model.s_axi_awvalid_i | model.s_axi_wvalid_i | model.s_axi_arvalid_i) != 0;
  return model.rst_ni == 0 ? kAllGatedClocks : request ? kBusClock : 0U;
}

// Returns the clocks that need the next edge, plus the gated clocks in `more`, without those in `stopped`.
template <class Model>
[[nodiscard]] Clocks needed_clocks(const Model& model, unsigned more = 0, unsigned stopped = 0) {
  const unsigned active = model.active_o | requested_clocks(model);
  return {.ungated = true, .gated = (active | more) & ~stopped};
}

// Sets the clock pins. Clocks{} sets all to 0.
template <class Model>
void set_clocks(Model& model, Clocks clocks) {
  model.clk_i = clocks.clk_i();
  model.clk_io_i = clocks.clk_io_i();
  model.clk_motion_i = clocks.clk_motion_i();
  model.clk_encoder_i = clocks.clk_encoder_i();
  model.clk_bus_i = clocks.clk_bus_i();
  model.clk_ik_i = clocks.clk_ik_i();
  model.clk_policy_i = clocks.clk_policy_i();
}

// A clock edge with Verilator's eval(). The clock pins are 0 before and after it.
template <class Model>
void eval_edge(Model& model, Clocks clocks) {
  set_clocks(model, clocks);
  model.eval();
  set_clocks(model, {});
  model.eval();
}

}  // namespace armature::cosim
