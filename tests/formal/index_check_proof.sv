// index_check of two axes: what it latches, and when it reports a mismatch, for every position and every line count.
`include "assert.svh"
`default_nettype none

module index_check_proof (
  input wire        clk_i,
  input wire        rst_ni,
  input wire [1:0]  rise_i,
  input wire [63:0] position_i,
  input wire [1:0]  up_i,
  input wire [1:0]  down_i,
  input wire [1:0]  check_i,
  input wire [1:0]  first_i,
  input wire [47:0] counts_per_rev_i
);

  logic [63:0] position_o;
  logic [1:0]  seen_o, mismatch_o;
  index_check #(.Axes(2)) u_dut (.*);

  `RESET_FIRST

  `ASSUME(OneStepAtATime, (up_i & down_i) == '0)

  for (genvar i = 0; i < 2; i++) begin : gen_axis
    // The position with the step of this clock, and its distance from the last index (before: from 0): 0, or one
    // revolution.
    logic signed [31:0] here, last_q;
    logic               seen_q, bad, bad_q, reverse_q, first_q;
    logic signed [32:0] distance, turn;
    assign here     = $signed(position_i[i*32 +: 32]) + (up_i[i] ? 32'sd1 : 32'sd0) - (down_i[i] ? 32'sd1 : 32'sd0);
    assign distance = 33'($signed(32'(here - last_q)));  // positions wrap
    assign turn     = $signed({9'd0, counts_per_rev_i[i*24 +: 24]});
    assign bad      = distance != '0 && distance != turn && distance != -turn;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) {seen_q, bad_q, last_q} <= '0;
      else begin
        bad_q <= rise_i[i] && (seen_q || first_i[i]) && check_i[i] && bad;
        if (rise_i[i]) {seen_q, last_q} <= {1'b1, here};
      end
      first_q   <= !seen_q;
      reverse_q <= distance == -turn && turn != '0 && seen_q && rise_i[i];
    end
    `ASSERT(LatchesThePositionOfTheIndex, position_o[i*32 +: 32] == last_q)
    `ASSERT(SeenAfterTheFirstIndex, seen_o[i] == seen_q)
    `ASSERT(MismatchWhenNoWholeRevolutionApart, mismatch_o[i] == bad_q)
    `REACH(Mismatch, mismatch_o[i])
    `REACH(MismatchOfTheFirst, mismatch_o[i] && first_q)
    `REACH(AWholeTurnBack, reverse_q && !mismatch_o[i] && check_i[i])
  end
  `REACH(MismatchOfOneOfTwo, mismatch_o == 2'b10)
  `REACH(MismatchOfBoth, mismatch_o == 2'b11)

endmodule

`default_nettype wire
