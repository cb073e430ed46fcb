// The clocks of a verilated arm_soc. Model: a class that Verilator has generated.
//
// In reset a gated clock needs every edge, afterwards only the edges before which its bit of active_o is 1. The other
// edges change no flop (proved in tests/formal), and a block without an edge costs no time.
#pragma once

namespace armature::cosim {

// The clocks that rise together, by the names of their pins.
struct Clocks {
  bool clk_i = false, clk_io_i = false, clk_motion_i = false, clk_encoder_i = false;
};

inline constexpr unsigned kAllGatedClocks = ~0u;  // bits as in active_o

// Returns the clocks that need the next edge, plus the gated clocks in `more`, without those in `stopped` (bits as in
// active_o).
template <class Model>
[[nodiscard]] Clocks needed_clocks(const Model& model, unsigned more = 0, unsigned stopped = 0) {
  const unsigned gated = ((model.rst_ni != 0 ? model.active_o : kAllGatedClocks) | more) & ~stopped;
  return {
      .clk_i = true, .clk_io_i = (gated & 1) != 0, .clk_motion_i = (gated & 2) != 0, .clk_encoder_i = (gated & 4) != 0};
}

// Sets the clock pins. Clocks{} sets all to 0.
template <class Model>
void set_clocks(Model& model, const Clocks& clocks) {
  model.clk_i = clocks.clk_i;
  model.clk_io_i = clocks.clk_io_i;
  model.clk_motion_i = clocks.clk_motion_i;
  model.clk_encoder_i = clocks.clk_encoder_i;
}

// A clock edge with Verilator's eval(). The clock pins are 0 before and after it.
template <class Model>
void eval_edge(Model& model, const Clocks& clocks) {
  set_clocks(model, clocks);
  model.eval();
  set_clocks(model, {});
  model.eval();
}

}  // namespace armature::cosim
