// stop_control: every cause stops within its bound, and only an explicit clear ends a stop.
`include "assert.svh"
`default_nettype none

module stop_control_proof (
  input wire        clk_i,
  input wire        rst_ni,
  input wire        estop_ni,
  input wire        stop_i,
  input wire        clear_estop_i,
  input wire        clear_watchdog_i,
  input wire        trigger_i,
  input wire        run_i,
  input wire        pending_i,
  input wire [7:0]  limit_i,
  input wire [11:0] tick_cycles_i
);

  logic        active_o, estop_pin_o, estop_o, watchdog_o, estop_event_o, watchdog_event_o, underrun_event_o;
  logic        heartbeat_o;
  logic [7:0]  in_a_row_o, idle_ticks_o;
  logic [31:0] underruns_o;
  logic awake_o;
  logic [11:0] now_i;  // starts anywhere
  always_ff @(posedge clk_i) now_i <= now_i + 12'd1;
  // Two underruns before the largest number, which therefore is within reach.
  localparam logic [31:0] UnderrunsReset = 32'hFFFF_FFFD;
  stop_control #(.UnderrunsReset(UnderrunsReset)) u_dut (.clk_gated_i(clk_i), .*);

  `RESET_FIRST

  // The pin as sampled one, two and three edges ago, and the signals of the previous clock.
  logic low_1_q, low_2_q, low_3_q, stop_q, estop_q, watchdog_q, clear_estop_q, clear_watchdog_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) {low_1_q, low_2_q, low_3_q, stop_q, estop_q, watchdog_q} <= '0;
    else begin
      {low_3_q, low_2_q, low_1_q} <= {low_2_q, low_1_q, !estop_ni};
      {stop_q, estop_q, watchdog_q} <= {stop_i, estop_o, watchdog_o};
    end
    {clear_estop_q, clear_watchdog_q} <= {clear_estop_i, clear_watchdog_i};
  end

  `ASSERT(SecondFlopIsTheReadout, estop_pin_o == low_2_q)
  `ASSERT(PinStopsAfterItsSecondFlop, !low_2_q || active_o)
  `ASSERT(PinLatchesTwoClocksAfterItsSample, !low_3_q || estop_o)
  `ASSERT(PinStopsUntilItIsLatched, !(low_2_q || low_3_q) || active_o)
  `ASSERT(RegisterStopsAtOnce, !stop_i || active_o)
  `ASSERT(RegisterLatches, !stop_q || estop_o)
  `ASSERT(EstopStaysUntilCleared, !(estop_q && !clear_estop_q) || estop_o)
  `ASSERT(WatchdogStaysUntilCleared, !(watchdog_q && !clear_watchdog_q) || watchdog_o)
  `ASSERT(NotClearedWhilePinLow, !(estop_q && low_3_q) || estop_o)
  `ASSERT(WatchdogNotClearedWhilePinLow, !(watchdog_q && low_3_q) || watchdog_o)
  `ASSERT(LatchedIsStopped, !(estop_o || watchdog_o) || active_o)

  // The watchdog with a constant limit: number of triggers in a row without the expected set.
  logic [7:0] limit_q;
  logic       after_q = 1'b0;
  logic [8:0] missed_q;
  always_ff @(posedge clk_i) begin
    after_q <= rst_ni;
    limit_q <= limit_i;
    if (!rst_ni || active_o) missed_q <= '0;
    else if (trigger_i) missed_q <= (run_i && !pending_i) ? missed_q + 9'd1 : '0;
  end
  `ASSUME(LimitIsLeftAlone, !after_q || limit_i == limit_q)
  `ASSERT(MissedIsTheReadout, missed_q == {1'b0, in_a_row_o} || watchdog_o)
  `ASSERT(WatchdogLatchesAtItsLimit, !(missed_q != '0 && missed_q >= {1'b0, limit_i}) || watchdog_o)

  // Every underrun is counted, up to the largest number.
  logic [31:0] underruns_q;
  logic        underrun_q;
  always_ff @(posedge clk_i) begin
    underruns_q <= rst_ni ? underruns_o : UnderrunsReset;
    underrun_q  <= rst_ni && trigger_i && run_i && !pending_i && !active_o;
  end
  `ASSERT(UnderrunsSaturate, !running_q ||
          underruns_o == ((underrun_q && underruns_q != '1) ? underruns_q + 32'd1 : underruns_q))
  `REACH(UnderrunBeyondTheLargestNumber, underrun_q && underruns_q == '1)

  // The watchdog's own ticks: clocks in the present one, and whole ticks since a set became active. No trigger is
  // needed for them. The lengths of tick and limit are constant.
  logic        set_active, tick_ends, counted_q;  // counted_q: the count had begun in the previous clock
  logic [11:0] tick_cycles_q, clocks_q, length;
  logic [8:0]  idle_q;
  assign set_active = trigger_i && pending_i && !active_o;
  assign length     = tick_cycles_i < 12'd2 ? 12'd2 : tick_cycles_i;
  assign tick_ends  = clocks_q == length - 12'd1;
  always_ff @(posedge clk_i) begin
    tick_cycles_q <= tick_cycles_i;
    clocks_q      <= clocks_q + 12'd1;
    if (tick_ends) {clocks_q, idle_q} <= {12'd0, idle_q + 9'd1};
    if (!rst_ni || !run_i || active_o || set_active || !counted_q) {clocks_q, idle_q} <= '0;
    counted_q     <= rst_ni && run_i && !active_o;
  end
  `ASSUME(TickIsLeftAlone, !running_q || tick_cycles_i == tick_cycles_q)
  (* hierconn *) wire        \u_dut.own_tick_q ;
  (* hierconn *) wire [11:0] \u_dut.own_end_q ;
  (* hierconn *) wire        \u_dut.counting_q ;
  `ASSERT(CountsAClockAfterItsStart, \u_dut.counting_q == counted_q)
  `ASSERT(NothingIsCountedBeforeTheStart, counted_q || {clocks_q, idle_q} == '0)
  `ASSERT(OwnTickIsItsLastClock, \u_dut.own_tick_q == tick_ends)
  `ASSERT(OwnTickHasItsLength, clocks_q < length)
  `ASSERT(OwnEndIsTheRestOfTheTick, !counted_q ||
          12'(\u_dut.own_end_q - now_i) == (tick_ends ? length - 12'd1 : 12'(length - 12'd2 - clocks_q)))
  `ASSERT(IdleIsTheReadout, idle_q == {1'b0, idle_ticks_o} || watchdog_o)
  `ASSERT(WatchdogLatchesWithoutATrigger, !(idle_q > 9'd1 && idle_q > {1'b0, limit_i}) || watchdog_o)
  `ASSERT(WatchdogNotBeforeItsLimit, !watchdog_event_o ||
          (trigger_i && run_i && !pending_i && missed_q + 9'd1 >= {1'b0, limit_i}) ||
          (tick_ends && run_i && !set_active && idle_q != '0 && idle_q >= {1'b0, limit_i}))

  // The heartbeat inverts with each set that becomes active, and only then.
  logic beat_q, beats_q;
  always_ff @(posedge clk_i) begin
    beat_q  <= rst_ni && heartbeat_o;
    beats_q <= rst_ni && set_active;
  end
  `ASSERT(BeatsWithEachSetAndOnlyThen, heartbeat_o == (beat_q ^ beats_q))
  `REACH(PinStops, low_2_q && !low_3_q && active_o && !stop_i && !estop_o && !watchdog_o)
  `REACH(FirstFlopAloneStopsNothing, low_1_q && !active_o)
  `REACH(ClearedEstop, estop_q && !estop_o)
  `REACH(ClearedWatchdog, watchdog_q && !watchdog_o)
  `REACH(WatchdogAfterFour, watchdog_event_o && limit_i == 8'd4 && missed_q == 9'd3)
  `REACH(WatchdogWithoutATrigger, watchdog_event_o && !trigger_i && limit_i == 8'd1)
  `REACH(SetInTheLastClock, set_active && tick_ends && run_i && idle_q != '0 && idle_q >= {1'b0, limit_i})
  `REACH(RefusedClear, estop_q && clear_estop_q && estop_o)

endmodule

`default_nettype wire
