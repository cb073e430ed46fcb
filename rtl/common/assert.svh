// Assertions and functional covers beside the logic they watch.
//
//   `ASSERT(Name, expr)   `expr` holds at every rising edge of clk_i outside reset (values before the edge).
//   `COVER(Name, expr)    some test makes `expr` hold at such an edge; tools/coverage counts.
//                         All passes of a generate loop are one cover.
//
// Assertions are checked by Verilator with --assert. Yosys and Icarus read no concurrent assertions, so there the
// macro is empty. State that only assertions need stands between `ifdef ASSERT_ON and `endif; a model built for speed
// passes +define+ASSERT_OFF and has neither. Covers exist only in models built with +define+COVER_ON.
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
