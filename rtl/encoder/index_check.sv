// Index latch of `Axes` encoders. It stores the position at every rising index edge. It reports a mismatch when two
// successive latched positions of an axis are neither equal nor one revolution apart: counts were lost or invented in
// between, or an index was missed. With `first_i` the first one is compared with position 0, where an encoder has an
// index if the arm stands at its zero after reset.
//
// The index must be gated with one quadrature state, as encoders for position latching do. Then its rising edge is at
// the same position in both directions of travel, and a reversal at the index gives a difference of 0.
`include "assert.svh"

module index_check #(
  parameter int Axes = 6
) (
  input  logic               clk_i,
  input  logic               rst_ni,            // synchronous
  input  logic [Axes-1:0]    rise_i,            // one cycle: the debounced index rises
  input  logic [Axes*32-1:0] position_i,        // position in counts before the step of this cycle
  input  logic [Axes-1:0]    up_i,              // the step of this cycle
  input  logic [Axes-1:0]    down_i,
  input  logic [Axes-1:0]    check_i,           // level: enables the report of mismatches
  input  logic [Axes-1:0]    first_i,           // level: also of the first index since reset
  input  logic [Axes*24-1:0] counts_per_rev_i,  // counts per revolution, 24 bits per axis, unsigned
  output logic [Axes*32-1:0] position_o,        // counts at the last rising edge, including the step of that cycle; 0
                                                // before the first one
  output logic [Axes-1:0]    seen_o,            // position_o is valid
  output logic [Axes-1:0]    mismatch_o         // one cycle, in the cycle after rise_i
);

  // Temporaries of the clocked process, written before they are read; evaluated only at an index.
  logic [Axes*32-1:0] latched;
  logic [31:0]        position, moved, turn;
  logic [Axes-1:0]    off;

  /* verilator lint_off BLKSEQ */
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      position_o <= '0;
      seen_o     <= '0;
      mismatch_o <= '0;
    end else if (rise_i != '0) begin
      latched = position_o;
      off     = '0;
      for (int i = 0; i < Axes; i++) begin
        if (rise_i[i]) begin
          position = position_i[i*32 +: 32] + (up_i[i] ? 32'd1 : down_i[i] ? -32'd1 : 32'd0);
          moved    = position - latched[i*32 +: 32];
          turn     = 32'(counts_per_rev_i[i*24 +: 24]);
          off[i]   = moved != 32'd0 && moved != turn && moved != -turn;
          latched[i*32 +: 32] = position;
        end
      end
      mismatch_o <= off & check_i & (seen_o | first_i);
      position_o <= latched;
      seen_o     <= seen_o | rise_i;
    end else if (mismatch_o != '0) begin
      mismatch_o <= '0;
    end
  end
  /* verilator lint_on BLKSEQ */

  `ASSERT(MismatchOnlyAfterALatch, (mismatch_o & ~seen_o) == '0)

  `COVER(FirstIndex, (rise_i & ~seen_o) != '0)
  `COVER(CheckedFirstIndex, (rise_i & ~seen_o & first_i & check_i) != '0)
  `COVER(Mismatch, mismatch_o != '0)
  `COVER(IndexInTheClockOfAStep, (rise_i & (up_i | down_i)) != '0)

endmodule
