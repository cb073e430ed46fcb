// From the emergency-stop pin to the step and direction pins: stop_control and one pulse generator, with any other
// cause of a stop.
`include "assert.svh"
`default_nettype none

module estop_proof (
  input wire               clk_i,
  input wire               rst_ni,
  input wire               estop_ni,
  input wire               stop_i,
  input wire               clear_estop_i,
  input wire               clear_watchdog_i,
  input wire               trigger_i,
  input wire               run_i,
  input wire               pending_i,
  input wire        [7:0]  limit_i,
  input wire signed [8:0]  count_i,
  input wire        [11:0] tick_cycles_i,
  input wire        [9:0]  dir_setup_i,
  input wire        [9:0]  dir_hold_i
);

  logic [11:0] now_i;  // starts anywhere
  always_ff @(posedge clk_i) now_i <= now_i + 12'd1;
  logic active_o, estop_pin_o, estop_o, step_o, dir_o;
  stop_control u_stop (
    .clk_gated_i(clk_i), .awake_o(), .watchdog_o(), .heartbeat_o(), .in_a_row_o(), .idle_ticks_o(), .underruns_o(),
    .estop_event_o(), .watchdog_event_o(), .underrun_event_o(), .*
  );
  pulse_gen u_gen (.stop_i(active_o), .emitted_o(), .unfinished_o(), .*);

  `RESET_FIRST

  `ASSUME(CountIsLimited, count_i >= -9'sd200 && count_i <= 9'sd200)

  // Edge 1 samples the pin low into the first flop, edge 2 into the second. Edge 3 is the first edge that must not
  // raise step or change the direction.
  logic step_q, dir_q, low_1_q, low_2_q, low_3_q, estop_q, clear_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) {step_q, dir_q, low_1_q, low_2_q, low_3_q, estop_q} <= '0;
    else {step_q, dir_q, low_1_q, low_2_q, low_3_q, estop_q} <= {step_o, dir_o, !estop_ni, low_1_q, low_2_q, estop_o};
    clear_q <= clear_estop_i;
  end
  `ASSERT(SecondFlopIsTheReadout, estop_pin_o == low_2_q)
  `ASSERT(NoRiseAfterTheSecondEdgeWithALowPin, !(step_o && !step_q && low_3_q))
  `ASSERT(NoTurnAfterTheSecondEdgeWithALowPin, !(dir_o != dir_q && low_3_q))
  `ASSERT(NoRiseWhileLatched, !(step_o && !step_q && estop_q))
  `REACH(RisesOnTheSecondEdgeWithALowPin, step_o && !step_q && low_2_q && !low_3_q)
  `REACH(RisesAfterAClear, step_o && !step_q && clear_q && !estop_q)

endmodule

`default_nettype wire
