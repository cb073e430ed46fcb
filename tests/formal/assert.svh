// Assertions for proofs. The include path has this file before rtl/common/assert.svh, so that every `ASSERT of the RTL,
// with the signals that it needs, is proved in each proof that contains its module.
//
//   `ASSERT(Name, expr)   proved: `expr` is true in every clock outside reset
//   `ASSUME(Name, expr)   assumed: `expr` is true in every clock outside reset
//   `REACH(Name, expr)    reachable: the solver finds a run to a clock with `expr` true, so the proofs are not vacuous
//   `RESET_FIRST          the first clock is a reset; any later clock may be one too
//
// All use the values of one clock, before the edge at its end. Each is an instance, so that its name is unique in
// the hierarchy, also within a generate loop.
`ifndef ASSERT_SVH
`define ASSERT_SVH

`define ASSERT_ON
`define ASSERT(Name, expr) formal_rule #(.Assume(1'b0)) Name (.live(rst_ni), .holds(expr));
`define ASSUME(Name, expr) formal_rule #(.Assume(1'b1)) Name (.live(rst_ni), .holds(expr));
`define REACH(Name, expr) formal_reach Name (.live(rst_ni), .seen(expr));
`define RESET_FIRST \
  logic running_q = 1'b0; \
  always_ff @(posedge clk_i) running_q <= 1'b1; \
  formal_rule #(.Assume(1'b1)) ResetFirst (.live(1'b1), .holds(running_q || !rst_ni));
// Simulation checks the functional covers of the RTL.
`define COVER(Name, expr)

`endif
