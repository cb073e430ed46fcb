// Assertions and functional covers, written beside the logic that they check.
//
//   `ASSERT(Name, expr)   `expr` is true at every rising edge of clk_i outside reset (values before the edge).
//   `COVER(Name, expr)    at least one test makes `expr` true at such an edge; tools/coverage counts it.
//                         All iterations of a generate loop are one cover.
//
// With --assert, Verilator checks the assertions. Yosys and Icarus do not support concurrent assertions, so their
// macro is empty. Signals that only assertions use are between `ifdef ASSERT_ON and `endif. A model built for speed
// defines ASSERT_OFF and has neither of them. Covers exist only in models that define COVER_ON.
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

`ifdef COVER_ON
`define COVER(Name, expr) \
  Name: cover property (@(posedge clk_i) disable iff (!rst_ni) (expr));
`else
`define COVER(Name, expr)
`endif

`endif
