// Direction set-up and hold times of pulse_gen up to 3 cycles; the assertions are those inside the module.
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

  logic dir_q, step_q, after_q;
  always_ff @(posedge clk_i) {dir_q, step_q, after_q} <= {dir_o, step_o, rst_ni};
  `REACH(TurnsAndRises, after_q && step_o && !step_q && dir_o && dir_setup_i == 10'd3)
  `REACH(TurnsBack, after_q && dir_q && !dir_o && dir_hold_i == 10'd3)

endmodule

`default_nettype wire
