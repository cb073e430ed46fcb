// Quadrature decoder of `Axes` encoders. It converts debounced A/B levels into steps of one count.
//
// Direction = a_new XOR b_prev (Vo 2021, Table 1); 1 is an increase. A simultaneous change of both lines has no
// direction. It is reported as illegal and does not change the position.
`include "assert.svh"

module quad_decoder #(
  parameter int Axes = 6
) (
  input  logic            clk_i,
  input  logic            rst_ni,     // synchronous
  input  logic [Axes-1:0] a_i,        // debounced
  input  logic [Axes-1:0] b_i,
  input  logic [Axes-1:0] known_i,    // both levels are valid; while 0 the decoder follows the levels without an event
  // Transition from the levels of the previous cycle to those of this cycle. One cycle per event, combinational.
  output logic [Axes-1:0] up_o,       // increment the position
  output logic [Axes-1:0] down_o,     // decrement the position
  output logic [Axes-1:0] illegal_o   // both lines changed at once
);

  logic [Axes-1:0] a_q, b_q;

  logic [Axes-1:0] a_edge, b_edge, step, increase;
  assign a_edge   = a_i ^ a_q;
  assign b_edge   = b_i ^ b_q;
  assign step     = (a_edge ^ b_edge) & known_i;
  assign increase = a_i ^ b_q;

  assign up_o      = step & increase;
  assign down_o    = step & ~increase;
  assign illegal_o = a_edge & b_edge & known_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      a_q <= '0;
      b_q <= '0;
    end else begin
      a_q <= a_i;
      b_q <= b_i;
    end
  end

  `ASSERT(NeverMovesOnIllegal, (illegal_o & (up_o | down_o)) == '0)
  `ASSERT(MovesOneWay, (up_o & down_o) == '0)

  `COVER(OneUpOneDown, up_o != '0 && down_o != '0)
  `COVER(Illegal, illegal_o != '0)
  `COVER(EdgeOfAnUnknownLine, ((a_edge | b_edge) & ~known_i) != '0)

endmodule
