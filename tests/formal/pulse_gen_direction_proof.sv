// Direction set-up and hold of pulse_gen for times up to 3 cycles, which may change at any time.
`include "assert.svh"
`default_nettype none

module pulse_gen_direction_proof (
  input wire               clk_i,
  input wire               rst_ni,
  input wire               trigger_i,
  input wire signed [8:0]  count_i,
  input wire               stop_i,
  input wire        [11:0] tick_cycles_i,
  input wire        [9:0]  dir_setup_i,
  input wire        [9:0]  dir_hold_i
);

  logic               step_o, dir_o;
  logic signed [31:0] emitted_o;
  logic signed [8:0]  unfinished_o;
  pulse_gen u_dut (.*);

  `RESET_FIRST

  `ASSUME(CountIsLimited, count_i >= -9'sd200 && count_i <= 9'sd200)

  `ASSUME(SetupIsShort, dir_setup_i < 10'd4)
  `ASSUME(HoldIsShort, dir_hold_i < 10'd4)

  logic               after_q = 1'b0;
  logic               step_q, dir_q;
  always_ff @(posedge clk_i) begin
    after_q      <= rst_ni;
    step_q       <= rst_ni && step_o;
    dir_q        <= dir_o;
  end

  logic rise, turn;
  assign rise = after_q && step_o && !step_q;
  assign turn = after_q && dir_o != dir_q;

  // Set-up: clocks that the direction must still stand before a rise. Hold: clocks since the last step edge, saturating.
  logic [9:0] setup, setup_rest_q, setup_before_q, age, age_q, age_before_q, hold_before_q;
  assign setup = turn ? setup_before_q : setup_rest_q;
  assign age   = (after_q && step_o != step_q) ? 10'd1 : age_q;
  always_ff @(posedge clk_i) begin
    setup_before_q <= dir_setup_i;
    hold_before_q  <= dir_hold_i;
    age_before_q   <= age;
    if (!rst_ni) begin
      setup_rest_q <= '0;
      age_q        <= '0;
    end else begin
      setup_rest_q <= (setup == '0) ? '0 : setup - 10'd1;
      age_q        <= (age == '1) ? age : age + 10'd1;
    end
  end
  `ASSERT(DirectionSetUp, !rise || setup == '0)
  `ASSERT(DirectionHold, !turn || age_before_q >= hold_before_q)
  `REACH(RisesAfterATurn, rise && dir_o && setup_before_q == 10'd3)
  `REACH(TurnsBack, turn && !dir_o && hold_before_q == 10'd3)

endmodule

`default_nettype wire
