// debounce of one line, for every time up to 15 cycles that is set and then left alone.
`include "assert.svh"
`default_nettype none

module debounce_proof (
  input wire       clk_i,
  input wire       rst_ni,
  input wire [7:0] time_i,
  input wire       valid_i,
  input wire [0:0] level_i
);

  logic [0:0] level_o, known_o, glitch_o;
  wire mode_i = 1'b0;  // restart on change, as in the paper
  debounce #(.Lines(1)) u_dut (.*);

  `RESET_FIRST

  logic       after_q = 1'b0;
  logic [7:0] time_q;
  logic       valid_q;
  always_ff @(posedge clk_i) begin
    after_q <= rst_ni;
    time_q  <= time_i;
    valid_q <= rst_ni && valid_i;
  end
  `ASSUME(TimeIsLeftAlone, !after_q || time_i == time_q)
  `ASSUME(TimeIsShort, time_i < 8'd16)
  `ASSUME(ValidForGood, !valid_q || valid_i)

  logic [7:0] needed;  // samples; 0 is as 1
  assign needed = (time_i == 8'd0) ? 8'd1 : time_i;

  for (genvar i = 0; i < 1; i++) begin : gen_line
    // The input had level_q for stable_q valid samples in a row, saturating, up to the clock before.
    logic       level_q, output_q, known_q;
    logic [8:0] stable_q;
    always_ff @(posedge clk_i) begin
      level_q  <= level_i[i];
      output_q <= level_o[i];
      known_q  <= rst_ni && known_o[i];
      if (!rst_ni || !valid_i) stable_q <= '0;
      else if (stable_q == '0 || level_i[i] != level_q) stable_q <= 9'd1;
      else if (stable_q != '1) stable_q <= stable_q + 9'd1;
    end

    `ASSERT(ChangesAfterAStableInput,
            !(known_q && level_o[i] != output_q) || (level_o[i] == level_q && stable_q >= {1'b0, needed}))
    `ASSERT(KnownAfterAStableInput,
            !(known_o[i] && !known_q) || (level_o[i] == level_q && stable_q >= {1'b0, needed}))
    `ASSERT(FollowsAStableInput, !(after_q && stable_q >= {1'b0, needed}) || level_o[i] == level_q)
    `ASSERT(KnowsAStableInput, !(after_q && stable_q > {1'b0, needed}) || known_o[i])
    `ASSERT(StaysKnown, !(after_q && known_q) || known_o[i])
    `REACH(Rises, known_q && level_o[i] && !output_q && needed == 8'd5)
    `REACH(Falls, known_q && !level_o[i] && output_q && needed == 8'd3)
    `REACH(Glitches, glitch_o[i])
  end

endmodule

`default_nettype wire
