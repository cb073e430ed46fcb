// From staged counts to the set of the next tick: a commit copies all counts at once, limited to -MaxCount..MaxCount;
// the trigger hands the whole set over and empties the bank. A tick can therefore never mix counts of two sets.
`include "assert.svh"

module commit_bank #(
  parameter int Axes     = 6,
  parameter int MaxCount = 200  // pulses per tick: 4 Mpps
) (
  input  logic               clk_i,
  input  logic               rst_ni,              // synchronous
  input  logic               trigger_i,           // one cycle: the tick begins
  input  logic               commit_i,            // one cycle; in the trigger cycle it is for the tick after
  input  logic               discard_i,           // level: empties the bank and refuses commits
  input  logic [Axes*16-1:0] staged_i,            // signed, pulses per tick
  input  logic [15:0]        staged_sequence_i,
  output logic [Axes*9-1:0]  count_o,             // signed; counts of the tick that begins if trigger_i, 0 if not pending
  output logic               pending_o,           // a set waits for the trigger
  output logic [15:0]        sequence_o,          // of the set that became active last
  output logic               clipped_o,           // one cycle: a count was limited
  output logic               recommit_o           // one cycle: a waiting set was replaced
);

  localparam logic signed [15:0] Limit = 16'(MaxCount);

  logic [15:0]     sequence_q;  // of the waiting set
  logic [Axes-1:0] above, below;

  for (genvar i = 0; i < Axes; i++) begin : gen_axis
    logic signed [15:0] staged;
    assign staged   = staged_i[i*16 +: 16];
    assign above[i] = staged > Limit;
    assign below[i] = staged < -Limit;

    logic signed [8:0] count_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) begin
        count_q <= '0;
      end else if (commit_i) begin
        if (above[i]) count_q <= 9'(MaxCount);
        else if (below[i]) count_q <= 9'(-MaxCount);
        else count_q <= staged[8:0];
      end
    end
    assign count_o[i*9 +: 9] = (pending_o && !discard_i) ? count_q : 9'sd0;
  end

  assign clipped_o  = commit_i && !discard_i && (above | below) != '0;
  assign recommit_o = commit_i && !discard_i && pending_o && !trigger_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      pending_o  <= 1'b0;
      sequence_o <= '0;
      sequence_q <= '0;
    end else if (discard_i) begin
      pending_o <= 1'b0;
    end else begin
      if (trigger_i) begin
        pending_o <= 1'b0;
        if (pending_o) sequence_o <= sequence_q;
      end
      if (commit_i) begin
        pending_o  <= 1'b1;
        sequence_q <= staged_sequence_i;
      end
    end
  end

  `ASSERT(NothingWithoutASet, pending_o || count_o == '0)

endmodule
