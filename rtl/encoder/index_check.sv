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
  input  logic [31:0] position_i,        // counts, before the step of this cycle
  input  logic        up_i,              // the step of this cycle
  input  logic        down_i,
  input  logic        check_i,           // level: report mismatches
  input  logic [23:0] counts_per_rev_i,
  output logic [31:0] position_o,        // at the last rising edge, including the step of its cycle
  output logic        seen_o,            // position_o is valid
  output logic        mismatch_o         // one cycle, after rise_i
);

  // Scratch of the clocked process, written before it is read; evaluated only at an index.
  logic [31:0] position, moved, turn;

  /* verilator lint_off BLKSEQ */
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      position_o <= '0;
      seen_o     <= 1'b0;
      mismatch_o <= 1'b0;
    end else if (rise_i) begin
      position = up_i ? position_i + 32'd1 : down_i ? position_i - 32'd1 : position_i;
      moved    = position - position_o;
      turn     = 32'(counts_per_rev_i);
      mismatch_o <= check_i && seen_o && moved != 32'd0 && moved != turn && moved != 32'd0 - turn;
      position_o <= position;
      seen_o     <= 1'b1;
    end else if (mismatch_o) begin
      mismatch_o <= 1'b0;
    end
  end
  /* verilator lint_on BLKSEQ */

  `ASSERT(MismatchOnlyAfterALatch, !mismatch_o || seen_o)

endmodule
