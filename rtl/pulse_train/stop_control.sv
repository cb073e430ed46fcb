// Sources that stop all pulses: the emergency-stop pin, the emergency-stop register and the watchdog. It also generates
// the heartbeat.
//
// The pin acts through its second flop: no pulse rises after the second clock edge that samples it low. The first flop
// may go metastable and has nearly a whole clock period to settle. So the six axes and the latch see the same level in
// the same clock, a direction line cannot change in the middle of a stop, and EMITTED is exact. README.md states the
// mean time between failures of the synchroniser.
//
// Only an explicit clear resets a latch. The clear is refused while the pin is low. A cause in the same cycle wins.
//
// An underrun is a trigger while `run_i` is 1 and no set is pending. While a stop is active underruns are not counted
// and the number in a row is cleared: the watchdog starts again from 0 after every stop.
//
// The watchdog has two causes. The first is `limit_i` underruns in a row. The second needs no trigger: the watchdog
// counts ticks of `tick_cycles_i` clocks itself while `run_i` is 1, and latches when limit + 1 of them have passed
// since a set became active. A stopped timer therefore stops the arm too. With triggers in time the first cause is
// always earlier. The end of an own tick is a time: a comparison needs no clock of its own.
//
// The heartbeat inverts with each set that becomes active. It stands still when the clock, the timer or the software
// stops, and during a stop.
`include "assert.svh"

module stop_control #(
  parameter logic [31:0] UnderrunsReset = 0  // initial value of underruns_o, for tests of its largest value
) (
  input  logic        clk_i,
  input  logic        rst_ni,            // synchronous
  input  logic        clk_gated_i,       // of all flops but those of the pin
  output logic        awake_o,           // clock request; 0: without an access no flop of clk_gated_i changes
  input  logic [11:0] now_i,             // time in clocks, wraps
  input  logic        estop_ni,          // pin, asynchronous, active low: emergency stop
  input  logic        stop_i,            // one cycle: emergency stop from the register
  input  logic        clear_estop_i,     // one cycle: clears the emergency-stop latch
  input  logic        clear_watchdog_i,  // one cycle: clears the watchdog latch
  input  logic        trigger_i,         // one cycle per tick
  input  logic        run_i,             // level: a trigger without a pending set is an underrun
  input  logic        pending_i,         // a committed set is waiting for the trigger
  input  logic [7:0]  limit_i,           // underruns in a row that latch the watchdog; 0 acts as 1
  input  logic [11:0] tick_cycles_i,     // length of an own tick of the watchdog; 0 and 1 act as 2
  output logic        active_o,          // no pulse may rise; combinational
  output logic        estop_pin_o,       // 1: the synchronised pin is low
  output logic        estop_o,           // latched emergency stop
  output logic        watchdog_o,        // latched watchdog
  output logic        heartbeat_o,       // inverts with each set that becomes active
  output logic [7:0]  in_a_row_o,        // underruns in a row; the watchdog latches before it could wrap
  output logic [7:0]  idle_ticks_o,      // own ticks since a set became active; likewise
  output logic [31:0] underruns_o,       // number since reset, saturating
  // One cycle per event, for the sticky fault flags.
  output logic        estop_event_o,     // the pin fell, or the register was written
  output logic        watchdog_event_o,  // the watchdog latches
  output logic        underrun_event_o   // an underrun
);

  (* ASYNC_REG = "TRUE" *) logic pin_first_q, pin_second_q;  // 1: pin low
  logic pin_third_q;
  assign estop_pin_o = pin_second_q;

  assign active_o = pin_second_q || stop_i || estop_o || watchdog_o;

  assign estop_event_o = stop_i || (pin_second_q && !pin_third_q);

  logic set_begins;  // a committed set becomes active

  always_comb begin
    set_begins       = 1'b0;
    underrun_event_o = 1'b0;
    if (trigger_i && !active_o) begin
      set_begins       = pending_i;
      underrun_event_o = run_i && !pending_i;
    end
  end

  // Own ticks. They begin in the clock after `counts` and after each set. own_tick_q is 1 in the last clock of each.
  logic        counts, counting_q, own_tick_ends, own_tick_q, timeout;
  logic [11:0] own_length, own_end_q;  // own_end_q: time of the last clock but one
  assign counts        = run_i && !active_o;
  assign own_length    = tick_cycles_i < 12'd2 ? 12'd2 : tick_cycles_i;
  assign own_tick_ends = counting_q && now_i == own_end_q;

  always_comb begin
    timeout          = 1'b0;
    watchdog_event_o = 1'b0;
    if (own_tick_q) timeout = counts && !set_begins && idle_ticks_o != '0 && idle_ticks_o >= limit_i;
    if (underrun_event_o) watchdog_event_o = {1'b0, in_a_row_o} + 9'd1 >= {1'b0, limit_i};
    if (timeout) watchdog_event_o = 1'b1;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      pin_first_q  <= 1'b0;
      pin_second_q <= 1'b0;
      pin_third_q  <= 1'b0;
    end else begin
      pin_first_q  <= !estop_ni;
      pin_second_q <= pin_first_q;
      pin_third_q  <= pin_second_q;
    end
  end

  logic activity, activity_q;
  assign activity = trigger_i || own_tick_ends || own_tick_q || counts != counting_q || pin_second_q != pin_third_q;
  assign awake_o  = activity || activity_q;

  always_ff @(posedge clk_gated_i) begin
    if (!rst_ni) activity_q <= 1'b0;
    else         activity_q <= activity;
  end

  always_ff @(posedge clk_gated_i) begin
    if (!rst_ni) begin
      estop_o    <= 1'b0;
      watchdog_o <= 1'b0;
    end else begin
      if (pin_second_q || stop_i) estop_o <= 1'b1;
      else if (clear_estop_i && !pin_second_q) estop_o <= 1'b0;

      if (watchdog_event_o) watchdog_o <= 1'b1;
      else if (clear_watchdog_i && !pin_second_q) watchdog_o <= 1'b0;
    end
  end

  always_ff @(posedge clk_gated_i) begin
    if (!rst_ni) begin
      in_a_row_o  <= '0;
      underruns_o <= UnderrunsReset;
    end else if (active_o) begin
      in_a_row_o <= '0;
    end else if (underrun_event_o) begin
      in_a_row_o <= in_a_row_o + 8'd1;
      if (underruns_o != '1) underruns_o <= underruns_o + 32'd1;
    end else if (trigger_i) begin
      in_a_row_o <= '0;
    end
  end

  always_ff @(posedge clk_gated_i) begin
    if (!rst_ni || !counts) begin
      counting_q   <= 1'b0;
      own_tick_q   <= 1'b0;
      idle_ticks_o <= '0;
    end else if (!counting_q || set_begins) begin
      counting_q   <= 1'b1;
      own_end_q    <= now_i + own_length - 12'd1;
      own_tick_q   <= 1'b0;
      idle_ticks_o <= '0;
    end else begin
      if (own_tick_ends) own_end_q <= own_end_q + own_length;
      own_tick_q <= own_tick_ends;
      if (own_tick_q) idle_ticks_o <= idle_ticks_o + 8'd1;
    end
  end

  always_ff @(posedge clk_gated_i) begin
    if (!rst_ni) heartbeat_o <= 1'b0;
    else if (set_begins) heartbeat_o <= !heartbeat_o;
  end

  `ASSERT(LatchedUntilCleared, !estop_o || active_o)

  `COVER(EstopByThePin, pin_second_q && !estop_o)
  `COVER(EstopByTheRegister, stop_i && !estop_o)
  `COVER(EstopCleared, clear_estop_i && !pin_second_q && estop_o)
  `COVER(EstopNotClearedWhileThePinIsLow, clear_estop_i && pin_second_q && estop_o)
  `COVER(EstopWinsOverItsClearing, clear_estop_i && stop_i)
  `COVER(UnderrunWithoutWatchdog, underrun_event_o && !watchdog_event_o)
  `COVER(Watchdog, watchdog_event_o)
  `COVER(WatchdogWithoutATrigger, timeout && !underrun_event_o)
  `COVER(SetInTheLastClock, set_begins && own_tick_q && idle_ticks_o >= limit_i && run_i)
  `COVER(WatchdogCleared, !pin_second_q && clear_watchdog_i && watchdog_o)
  `COVER(RunOfUnderrunsEnds, trigger_i && !underrun_event_o && !active_o && in_a_row_o != '0)

endmodule
