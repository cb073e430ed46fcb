// The cells behind the macros of assert.svh. tools/formal knows a property by its label and the path of its instance.
`include "assert.svh"  // read first: a source beside the RTL's own assert.svh would find that one
`default_nettype none

// Asserts or assumes `holds` wherever `live`.
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

// Asserts that `seen` never happens; tools/formal demands a counterexample.
module formal_reach (
  input wire live,
  input wire seen
);
  always_comb reached: assert (!live || !seen);
endmodule

`default_nettype wire
