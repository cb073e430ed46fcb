// Index latch of one axis: keeps the position of every rising index edge, and reports when two successive ones are not
// 0 or one whole revolution apart, because then counts were lost or invented in between.
//
// The index must be gated with one quadrature state, as encoders for position latching do: then both directions of
// travel meet its rising edge at the same position, and a turn back over the index counts as 0.
`include "assert.svh"

module index_check (
  input  logic        clk_i,
  input  logic        rst_ni,            // synchronous
  input  logic        rise_i,            // one cycle: the debounced index rises
  input  logic [31:0] position_i,        // counts, including the step of this cycle
  input  logic        check_i,           // level: report mismatches
  input  logic [23:0] counts_per_rev_i,
  output logic [31:0] position_o,        // at the last rising edge
  output logic        seen_o,            // position_o is valid
  output logic        mismatch_o         // with rise_i
);

  logic [31:0] moved;
  assign moved = position_i - position_o;

  assign mismatch_o = rise_i && check_i && seen_o && moved != 32'd0 && moved != 32'(counts_per_rev_i) &&
                      moved != 32'd0 - 32'(counts_per_rev_i);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      position_o <= '0;
      seen_o     <= 1'b0;
    end else if (rise_i) begin
      position_o <= position_i;
      seen_o     <= 1'b1;
    end
  end

  `ASSERT(MismatchOnlyAfterALatch, !mismatch_o || seen_o)

endmodule
