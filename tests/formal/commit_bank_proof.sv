// commit_bank of two axes: a tick gets the whole last committed set, limited and only once, or zeros.
`include "assert.svh"
`default_nettype none

module commit_bank_proof (
  input wire        clk_i,
  input wire        rst_ni,
  input wire        trigger_i,
  input wire        commit_i,
  input wire        discard_i,
  input wire [31:0] staged_i,
  input wire [15:0] staged_sequence_i
);

  logic [17:0] count_o;
  logic        pending_o, clipped_o, recommit_o;
  logic [15:0] sequence_o;
  commit_bank #(.Axes(2)) u_dut (.*);

  `RESET_FIRST

  function automatic logic signed [15:0] limited(input logic signed [15:0] count);
    limited = count > 16'sd200 ? 16'sd200 : count < -16'sd200 ? -16'sd200 : count;
  endfunction

  // The pending set: that of the last commit, until a trigger or a discard.
  logic               after_q = 1'b0;
  logic               waits_q, trigger_q, discard_q, clips_q;
  logic signed [15:0] first_q, second_q;
  logic [15:0]        sequence_q, expected_q;
  logic               beyond;
  assign beyond = limited(staged_i[15:0]) != $signed(staged_i[15:0]) ||
                  limited(staged_i[31:16]) != $signed(staged_i[31:16]);
  always_ff @(posedge clk_i) begin
    after_q   <= rst_ni;
    trigger_q <= rst_ni && trigger_i && !commit_i;
    discard_q <= rst_ni && discard_i;
    clips_q   <= rst_ni && commit_i && !discard_i && beyond;
    if (!rst_ni || discard_i) waits_q <= 1'b0;
    else if (commit_i) waits_q <= 1'b1;
    else if (trigger_i) waits_q <= 1'b0;
    if (rst_ni && commit_i && !discard_i) begin
      first_q    <= limited(staged_i[15:0]);
      second_q   <= limited(staged_i[31:16]);
      sequence_q <= staged_sequence_i;
    end
    if (!rst_ni) expected_q <= '0;
    else if (trigger_i && waits_q && !discard_i) expected_q <= sequence_q;
  end

  logic signed [15:0] first, second;
  assign first  = 16'($signed(count_o[8:0]));
  assign second = 16'($signed(count_o[17:9]));

  `ASSERT(WithinTheLimit, first <= 16'sd200 && first >= -16'sd200 && second <= 16'sd200 && second >= -16'sd200)
  `ASSERT(PendingIsAWaitingSet, !after_q || pending_o == waits_q)
  `ASSERT(IsTheSetCommittedLast, !(pending_o && waits_q && !discard_i) || (first == first_q && second == second_q))
  `ASSERT(TakenOnce, !trigger_q || (count_o == '0 && !pending_o))
  `ASSERT(DiscardEmpties, !(discard_i || discard_q) || count_o == '0)
  `ASSERT(SequenceIsThatOfTheSet, !after_q || sequence_o == expected_q)
  `ASSERT(ReportsALimitedCount, !after_q || clipped_o == clips_q)
  `ASSERT(ReportsAReplacedSet, recommit_o == (commit_i && !discard_i && !trigger_i && pending_o))

  `REACH(TakesASet, trigger_i && first == 16'sd200 && second == -16'sd7)
  `REACH(ReplacesASet, recommit_o)
  `REACH(CommitAtTheTrigger, commit_i && trigger_i && pending_o && !discard_i)

endmodule

`default_nettype wire
