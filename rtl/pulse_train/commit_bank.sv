// Shadow registers of the pulse counts. A commit copies all staged counts at once, limited to -MaxCount..MaxCount. The
// trigger makes the whole set active and empties the bank. A tick therefore never mixes counts of two sets.
`include "assert.svh"

module commit_bank #(
  parameter int Axes     = 6,
  parameter int MaxCount = 200  // pulses per tick: 4 Mpps
) (
  input  logic               clk_i,
  input  logic               rst_ni,              // synchronous
  input  logic               trigger_i,           // one cycle: a tick begins and the committed set becomes active
  input  logic               commit_i,            // one cycle; in the trigger cycle: for the following tick
  input  logic               discard_i,           // level: empties the bank and ignores commits
  input  logic [Axes*16-1:0] staged_i,            // signed, pulses per tick
  input  logic [15:0]        staged_sequence_i,   // sequence number of staged_i
  output logic [Axes*9-1:0]  count_o,             // signed, pulses per tick; valid in the trigger cycle
  output logic               pending_o,           // a committed set is waiting for the trigger
  output logic [15:0]        sequence_o,          // sequence number of the set that became active last
  output logic               clipped_o,           // one cycle: a count was limited
  output logic               recommit_o           // one cycle: a pending set was replaced
);

  localparam logic signed [15:0] Limit = 16'(MaxCount);

  logic [Axes*9-1:0] count_q;     // limited
  logic [15:0]       sequence_q;  // of the pending set
  assign count_o = (pending_o && !discard_i) ? count_q : '0;

  assign recommit_o = commit_i && !discard_i && pending_o && !trigger_i;

  // Temporaries of the clocked process, written before they are read; evaluated only for a commit.
  logic signed [15:0] staged;
  logic [Axes*9-1:0]  limited;
  logic               clipped;

  /* verilator lint_off BLKSEQ */
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      count_q   <= '0;
      clipped_o <= 1'b0;
    end else if (commit_i) begin
      clipped = 1'b0;
      for (int i = 0; i < Axes; i++) begin
        staged = staged_i[i*16 +: 16];
        if (staged > Limit || staged < -Limit) begin
          clipped = !discard_i;
          staged  = staged[15] ? -Limit : Limit;
        end
        limited[i*9 +: 9] = staged[8:0];
      end
      count_q   <= limited;
      clipped_o <= clipped;
    end else if (clipped_o) begin
      clipped_o <= 1'b0;
    end
  end
  /* verilator lint_on BLKSEQ */

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      pending_o  <= 1'b0;
      sequence_o <= '0;
      sequence_q <= '0;
    end else if (discard_i) begin
      pending_o <= 1'b0;
    end else begin
      if (trigger_i && pending_o) sequence_o <= sequence_q;
      if (trigger_i || commit_i) pending_o <= commit_i;
      if (commit_i) sequence_q <= staged_sequence_i;
    end
  end

  `ASSERT(NothingWithoutASet, pending_o || count_o == '0)

  `COVER(Clipped, clipped_o)
  `COVER(Recommit, recommit_o)
  `COVER(CommitAtTheTrigger, commit_i && trigger_i && !discard_i)
  `COVER(DiscardOfAWaitingSet, discard_i && pending_o)
  `COVER(TriggerWithoutASet, trigger_i && !pending_o)

endmodule
