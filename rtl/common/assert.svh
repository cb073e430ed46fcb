// Assertions beside the logic they guard.
//
//   `ASSERT(Name, expr)   `expr` holds at every rising edge of clk_i outside reset (values before the edge).
//
// They are checked by Verilator with --assert. Yosys and Icarus read no concurrent assertions, so there the
// macro is empty. State that only assertions need stands between `ifdef ASSERT_ON and `endif; a model built for speed
// passes +define+ASSERT_OFF and has neither.
`ifndef ASSERT_SVH
`define ASSERT_SVH

`ifdef VERILATOR
`ifndef ASSERT_OFF
`define ASSERT_ON
`endif
`endif

`ifdef ASSERT_ON
`define ASSERT(Name, expr) \
  Name: assert property (@(posedge clk_i) disable iff (!rst_ni) (expr)) else $error(`"Name`");
`else
`define ASSERT(Name, expr)
`endif

`endif
