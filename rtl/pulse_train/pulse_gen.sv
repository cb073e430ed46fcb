// Pulse-and-direction output of one axis: spreads a signed number of pulses evenly over one tick.
//
// Distribution: in every running cycle acc += 2|count|. When acc reaches the window, acc -= window and step toggles.
// Starting from 0 this gives exactly |count| pulses, with every edge within one cycle of its ideal time. (Vo 2021,
// Figure 6, uses a rounded half period instead and reaches 64 of 201 counts.) The additions take place from the cycle
// after the trigger up to and including the next trigger cycle, so the last falling edge coincides with the next
// trigger edge. The window starts at `tick_cycles_i` and shrinks by one in every cycle in which the axis is blocked, so
// that the pulses spread over the rest of the tick. The axis is blocked while
//   - a reversal is pending: direction changes only while step is low and `dir_hold_i` cycles after the FALLING edge of
//     the last pulse; it is then stable for `dir_setup_i` cycles before the distribution starts;
//   - a pulse is still high from a previous tick that was too short: it first completes its minimum width.
//
// A toggle that would make a level shorter than MinWidthCycles is delayed. Pulses that do not fit before the next
// trigger are reported on `unfinished_o`; they are neither carried over nor dropped silently. A late trigger adds no
// pulse. No rising edge falls on a trigger edge, so `emitted_o` and `unfinished_o` are exact in the trigger cycle:
// count = change of emitted_o + unfinished_o in every tick.
//
// A tick is long enough if the next trigger comes `tick_cycles_i` cycles or more after its trigger, and
//   tick_cycles_i >= 2 MinWidthCycles |count_i| + B
// Then all its pulses rise, and the last one falls on the trigger edge or before. B is the number of cycles in which
// the axis is blocked: the larger of dir_hold_i and 1, plus dir_setup_i, if the tick reverses; up to MinWidthCycles - 1
// if a pulse is high at the trigger; the rest of a set-up time that runs at the trigger. With MinWidthCycles - 1 cycles
// less all pulses still rise, but the last one can be high at the next trigger. Proved in tests/formal: pulse_gen_all.
//
// `stop_i` cancels the running tick: there is no rising edge from the next clock edge on. A pulse that is already high
// keeps its minimum width, because the drive has counted it. The cancelled pulses are reported as unfinished.
`include "assert.svh"

module pulse_gen #(
  parameter int                 MinWidthCycles = 6,  // cycles, minimum of step high and step low; 4 Mpps: 6 and 7
  parameter logic signed [31:0] EmittedReset   = 0   // initial value of emitted_o, for tests of its wrap-around
) (
  input  logic               clk_i,
  input  logic               rst_ni,         // synchronous
  input  logic               trigger_i,      // one cycle: the running tick ends, count_i becomes active
  input  logic signed [8:0]  count_i,        // pulses of the tick that begins, -200..200
  input  logic               stop_i,         // level: no rising edge from the next clock edge on
  input  logic [11:0]        tick_cycles_i,  // cycles between triggers, >= 2 MinWidthCycles |count_i| + B
  input  logic [9:0]         dir_setup_i,    // cycles from a direction change to the start of the distribution
  input  logic [9:0]         dir_hold_i,     // cycles from the falling edge of the last pulse to a direction change
  (* IOB = "TRUE" *)
  output logic               step_o,         // a rising edge is one pulse
  (* IOB = "TRUE" *)
  output logic               dir_o,          // 1: positive
  output logic signed [31:0] emitted_o,      // rising edges since reset, signed by direction; wraps
  output logic signed [8:0]  unfinished_o    // count of the running tick minus the pulses emitted in it
);

  localparam logic [9:0] MinWidth  = 10'(MinWidthCycles);
  localparam logic [9:0] LongSince = 10'h3FF;  // since_edge_q saturates here; at least as large as any dir_hold_i

  logic        running_q;     // edges of this tick are left
  logic        own_pulse_q;   // the high pulse belongs to the running tick
  logic [8:0]  increment_q;   // 2|count|
  logic [12:0] window_q;      // additions over which the pulses are spread; at least increment_q, which bounds acc_q
  logic [12:0] acc_q;         // below window_q
  logic [9:0]  since_edge_q;  // cycles of the present step level including this one, saturating
  logic [9:0]  setup_q;       // set-up cycles left

  // The state before the clock edge, read before any of it is assigned ("Writing for speed" in rtl/README.md).
  /* verilator tracing_off */
  logic              step, own_pulse, dir;
  logic signed [8:0] unfinished, count;
  logic [8:0]        increment;
  logic [9:0]        since_edge, setup;
  logic [12:0]       window, acc;  // acc: with the increment of this cycle
  /* verilator tracing_on */

  /* verilator lint_off BLKSEQ */
  always_ff @(posedge clk_i) begin
    since_edge = since_edge_q;
    setup      = setup_q;
    step       = step_o;
    own_pulse  = own_pulse_q;
    dir        = dir_o;
    unfinished = unfinished_o;
    increment  = increment_q;
    window     = window_q;
    acc        = acc_q + 13'(increment);
    if (since_edge != LongSince) since_edge_q <= since_edge + 10'd1;
    if (setup != '0) setup_q <= setup - 10'd1;

    if (running_q || step) begin
      if (step ? !own_pulse : (setup != '0 || dir == unfinished[8])) begin
        // Blocked by a pulse that is high from the previous tick, or by a reversal.
        if (window > 13'(increment)) window_q <= window - 13'd1;
        if (step) begin
          if (since_edge >= MinWidth) begin
            step_o       <= 1'b0;
            since_edge_q <= 10'd1;
          end
        end else if (setup == '0 && since_edge >= dir_hold_i && !trigger_i && !stop_i) begin
          dir_o   <= !dir;
          setup_q <= dir_setup_i;
        end
      end else if (acc < window) begin
        acc_q <= acc;
      end else if (since_edge >= MinWidth && (step || !(trigger_i || stop_i))) begin
        acc_q        <= acc - window;
        step_o       <= !step;
        since_edge_q <= 10'd1;
        if (step) begin
          running_q <= unfinished != '0;
        end else begin
          own_pulse_q  <= 1'b1;
          emitted_o    <= dir ? emitted_o + 32'sd1 : emitted_o - 32'sd1;
          unfinished_o <= dir ? unfinished - 9'sd1 : unfinished + 9'sd1;
        end
      end

      if (stop_i) begin
        running_q   <= 1'b0;
        own_pulse_q <= 1'b0;
      end
    end

    if (trigger_i) begin
      count        = count_i;
      increment    = {count[8] ? 8'(-count) : 8'(count), 1'b0};
      running_q    <= count != '0 && !stop_i;
      own_pulse_q  <= 1'b0;
      unfinished_o <= count;
      increment_q  <= increment;
      window_q     <= (tick_cycles_i < 12'(increment)) ? 13'(increment) : 13'(tick_cycles_i);
      acc_q        <= '0;
    end

    if (!rst_ni) begin
      step_o       <= 1'b0;
      dir_o        <= 1'b0;
      emitted_o    <= EmittedReset;
      unfinished_o <= '0;
      running_q    <= 1'b0;
      own_pulse_q  <= 1'b0;
      increment_q  <= '0;
      window_q     <= '0;
      acc_q        <= '0;
      since_edge_q <= '0;
      setup_q      <= '0;
    end
  end
  /* verilator lint_on BLKSEQ */

`ifdef ASSERT_ON
  logic        step_before_q, dir_before_q, stop_before_q;
  logic [9:0]  hold_before_q, setup_before_q;
  logic [9:0]  setup_in_force_q;  // dir_setup_i at the last direction change
  logic [10:0] width_q;           // cycles since the last step edge, saturating
  logic [10:0] dir_age_q;         // cycles since the last direction edge, saturating
  logic [8:0]  commanded_q;       // |count| of the running tick
  logic [8:0]  rises_q;           // rising edges of the running tick
  logic        risen, edge_seen, turned;
  logic [8:0]  left;              // |unfinished_o|
  assign risen     = step_o && !step_before_q;
  assign edge_seen = step_o != step_before_q;
  assign turned    = dir_o != dir_before_q;
  assign left      = unfinished_o[8] ? 9'(-unfinished_o) : 9'(unfinished_o);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      step_before_q    <= 1'b0;
      dir_before_q     <= 1'b0;
      stop_before_q    <= 1'b0;
      hold_before_q    <= '0;
      setup_before_q   <= '0;
      setup_in_force_q <= '0;
      width_q          <= '1;
      dir_age_q        <= '1;
      commanded_q      <= '0;
      rises_q          <= '0;
    end else begin
      step_before_q  <= step_o;
      dir_before_q   <= dir_o;
      stop_before_q  <= stop_i;
      hold_before_q  <= dir_hold_i;
      setup_before_q <= dir_setup_i;
      if (turned) setup_in_force_q <= setup_before_q;
      width_q        <= edge_seen ? 11'd1 : (width_q == '1) ? width_q : width_q + 11'd1;
      dir_age_q      <= turned ? 11'd1 : (dir_age_q == '1) ? dir_age_q : dir_age_q + 11'd1;
      rises_q        <= trigger_i ? '0 : rises_q + 9'(risen);
      if (trigger_i) commanded_q <= count_i[8] ? 9'(-count_i) : 9'(count_i);
    end
  end

  `ASSERT(DirStableWhileHigh, !(turned && (step_o || step_before_q)))
  `ASSERT(DirHold, !(turned && width_q < 11'(hold_before_q)))
  `ASSERT(DirSetup, !(risen && dir_age_q < 11'(setup_in_force_q)))
  `ASSERT(NoRiseAfterStop, !(risen && stop_before_q))
  `ASSERT(MinimumWidth, !(edge_seen && width_q < 11'(MinWidthCycles)))
  `ASSERT(EmittedWithinCommand, rises_q + 9'(risen) <= commanded_q)

  `ASSERT(LongSinceCoversEveryHoldTime, dir_hold_i <= LongSince)

  // Invariants of the state. Together they are inductive: the proof of the assertions above needs a single step.
  `ASSERT(SinceEdgeIsTheWidth,
          edge_seen ? since_edge_q == 10'd1
                    : width_q == '1 || since_edge_q == (width_q < 11'(LongSince) ? 10'(width_q + 11'd1) : LongSince))
  `ASSERT(SetupIsTheRestOfItsTime,
          turned ? setup_q == setup_before_q
                 : setup_q == (dir_age_q < 11'(setup_in_force_q) ? 10'(11'(setup_in_force_q) - dir_age_q) : '0))
  `ASSERT(EmittedAndLeftAreTheCommand, rises_q + 9'(risen) + left == commanded_q)
  `ASSERT(RunningMeansPulsesLeft, !running_q || (step_o && own_pulse_q) || unfinished_o != '0)
  `ASSERT(OwnPulseMeansRunning, !(step_o && own_pulse_q) || running_q)
  `ASSERT(SetupIsBetweenPulses, !step_o || setup_q == '0)
  `ASSERT(DirectionIsTheCommands, !(running_q && own_pulse_q) || unfinished_o == '0 || dir_o != unfinished_o[8])
  `ASSERT(IncrementIsTwiceTheCommand, increment_q == {commanded_q[7:0], 1'b0})
  `ASSERT(RunningMeansACommand, !running_q || increment_q != '0)
  `ASSERT(WindowTakesTheIncrement, 13'(increment_q) <= window_q)
  `ASSERT(AccumulatorBelowWindow, !running_q || acc_q < window_q)
  `ASSERT(AccumulatorRestsWhileBlocked,
          !(running_q && acc_q != '0) || (setup_q == '0 && (step_o ? own_pulse_q : dir_o != unfinished_o[8])))
`endif

  `COVER(TickBeginsWithAHighPulse, trigger_i && step_o)
  `COVER(TickBeginsWithPulsesLeft, trigger_i && unfinished_o != '0)
  `COVER(ReversalWaitsForTheHoldTime, running_q && !step_o && setup_q == '0 && dir_o == unfinished_o[8] &&
         since_edge_q < dir_hold_i)
  `COVER(ReversalWaitsForTheSetupTime, running_q && !step_o && setup_q != '0)
  `COVER(PulseWaitsForTheMinimumWidth, running_q && acc_q + 13'(increment_q) >= window_q && since_edge_q < MinWidth)
  `COVER(StopOfAHighPulse, stop_i && step_o)
  `COVER(StopBetweenPulses, stop_i && running_q && !step_o)
  `COVER(TheLastPulseEndsTheTick, running_q && step_o && own_pulse_q && unfinished_o == '0)

endmodule
