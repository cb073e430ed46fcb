// Assertions for proofs. It stands in front of rtl/common/assert.svh in the include path, so that every `ASSERT of the
// RTL, with the state that it needs, is proved in each proof in which its module takes part.
//
//   `ASSERT(Name, expr)   proved: `expr` holds in every clock outside reset
//   `ASSUME(Name, expr)   the environment: `expr` holds in every clock outside reset
//   `REACH(Name, expr)    the solver finds a run to a clock in which `expr` holds: the proofs beside it are not vacuous
//   `RESET_FIRST          the first clock is a reset; any later clock may be one too
//
// All look at the values of one clock, before the edge that ends it. Each is an instance, so that its name is unique in
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
// Functional covers of the RTL are the business of simulation.
`define COVER(Name, expr)

`endif
