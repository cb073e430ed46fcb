// The cells of the macros in assert.svh. tools/formal identifies a property by its label and the path of its instance.
`include "assert.svh"  // read first: a source next to the assert.svh of the RTL would include that one
`default_nettype none

// Asserts or assumes that `holds` is 1 in every clock with `live`.
module formal_rule #(
  parameter bit Assume = 1'b0
) (
  input wire live,
  input wire holds
);
  if (Assume) begin : gen_assume
    always_comb assume (!live || holds);
  end else begin : gen_assert
    always_comb proved: assert (!live || holds);
  end
endmodule

// Asserts that `seen` is never 1; tools/formal requires a counterexample.
module formal_reach (
  input wire live,
  input wire seen
);
  always_comb reached: assert (!live || !seen);
endmodule

`default_nettype wire
