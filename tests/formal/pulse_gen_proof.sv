// pulse_gen from the outside: its pins compared with the commands. The assertions inside the module are proved as well.
//
// Triggers may come at any time, and settings and the stop may change at any time.
`include "assert.svh"
`default_nettype none

module pulse_gen_proof (
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

  logic               after_q = 1'b0;
  logic               step_q, dir_q, stop_q, trigger_q;
  logic signed [8:0]  count_q, unfinished_q;
  logic signed [31:0] emitted_q;
  always_ff @(posedge clk_i) begin
    after_q      <= rst_ni;
    step_q       <= rst_ni && step_o;
    dir_q        <= dir_o;
    stop_q       <= stop_i;
    trigger_q    <= rst_ni && trigger_i;
    count_q      <= count_i;
    unfinished_q <= unfinished_o;
    emitted_q    <= emitted_o;
  end

  logic stopped_q;  // there was a stop since the reset
  always_ff @(posedge clk_i) stopped_q <= rst_ni && (stopped_q || stop_i);

  logic rise, turn;
  assign rise = after_q && step_o && !step_q;
  assign turn = after_q && dir_o != dir_q;

  // The rest of the command of the tick. Every rising edge decrements it, in its direction. Therefore a tick never has
  // more pulses than commanded, and emitted + unfinished = commanded.
  `ASSERT(TriggerTakesTheCommand, !trigger_q || unfinished_o == count_q)
  `ASSERT(RiseTakesOne, !rise || unfinished_o == (dir_o ? unfinished_q - 9'sd1 : unfinished_q + 9'sd1))
  `ASSERT(OnlyARiseTakes, !(after_q && !trigger_q && !rise) || unfinished_o == unfinished_q)
  `ASSERT(NoRiseWithoutACommand, !rise || (dir_o ? unfinished_q > 9'sd0 : unfinished_q < 9'sd0))
  `ASSERT(NoRiseOnATrigger, !(rise && trigger_q))
  `ASSERT(RiseIsCounted, !rise || emitted_o == (dir_o ? emitted_q + 32'sd1 : emitted_q - 32'sd1))
  `ASSERT(NothingElseIsCounted, !(after_q && !rise) || emitted_o == emitted_q)

  // A stop, also one in the clock of the trigger, cancels the tick: no pulse rises until a trigger without a stop.
  logic cancelled_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || stop_i) cancelled_q <= rst_ni;
    else if (trigger_i) cancelled_q <= 1'b0;
  end
  (* hierconn *) wire \u_dut.running_q ;
  `ASSERT(NoRiseInTheClockAfterAStop, !(rise && stop_q))
  `ASSERT(NoRiseAfterAStopUntilTheNextTick, !(rise && cancelled_q))
  `ASSERT(ACancelledTickDoesNotRun, !(cancelled_q && \u_dut.running_q ))
  `ASSERT(DirectionStandsDuringAPulse, !(turn && (step_o || step_q)))
  `ASSERT(NoTurnInAStop, !(turn && stop_q))

  `REACH(Pulses, after_q && !step_o && step_q && unfinished_o == '0)
  `REACH(TwoPulses, rise && count_q == 9'sd0 && emitted_o == 32'sd2)
  `REACH(TurnsBack, turn && emitted_o == 32'sd1)
  `REACH(StopCancels, stop_q && unfinished_o != '0 && step_o)
  `REACH(PulsesInTheTickAfterAStop, rise && stopped_q)
  `REACH(LateTrigger, trigger_q && unfinished_q != '0)

endmodule

`default_nettype wire
