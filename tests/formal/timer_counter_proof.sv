// timer_counter with all 32 bits: the distance between two wraps, up and down, for every load value.
//
// Single clocks prove a statement about up to 2^32 clocks: a wrap sets `rest_q` to the period, a clock decrements it,
// and the counter must wrap exactly when `rest_q` reaches its end.
`include "assert.svh"
`default_nettype none

module timer_counter_proof (
  input wire        clk_i,
  input wire        rst_ni,
  input wire        load_i,
  input wire        enable_i,
  input wire        down_i,
  input wire        reload_i,
  input wire [31:0] load_value_i
);

  // One timer without coupling.
  logic [31:0] count_o;
  logic        wraps_o, expires, reloads;
  timer_counter u_dut (
    .clk_i, .rst_ni, .load_i, .down_i, .reload_i, .load_value_i, .count_o, .wraps_o,
    .step_i       (enable_i),
    .restart_i    (1'b0),
    .free_i       (1'b0),
    .follow_i     (1'b0),
    .lower_i      (1'b0),
    .upper_count_i(32'd0),
    .upper_i      (1'b0),
    .carry_i      (1'b0),
    .upper_down_i (1'b0),
    .expires_o    (expires),
    .reloads_o    (reloads)
  );

  `RESET_FIRST

  // A period is steady if the counter has only counted since the previous wrap: same value, same direction, no
  // load, no reset. A stopped counter only makes the period longer.
  logic        steady_q, first_q, down_q, wrapped_q, stopped_q;
  logic [31:0] value_q, count_q, rest_q;
  logic        same;
  assign same = reload_i && load_value_i == value_q && down_i == down_q;

  always_ff @(posedge clk_i) begin
    stopped_q <= rst_ni && !enable_i && !load_i;
    count_q   <= count_o;
    wrapped_q <= rst_ni && wraps_o;
    value_q   <= load_value_i;
    down_q    <= down_i;
    if (!rst_ni || load_i) steady_q <= 1'b0;
    else if (wraps_o) steady_q <= 1'b1;
    else if (!same) steady_q <= 1'b0;

    // The clock after the wrap is the first of its period and has the wrapped value. TLR + 1 clocks, or 2^32 - TLR
    // counting up, follow before the next wrap: TLR + 2, or 2^32 + 1 - TLR, in total.
    if (!rst_ni || load_i) first_q <= 1'b0;
    else if (wraps_o) first_q <= 1'b1;
    else if (enable_i && reload_i) first_q <= 1'b0;
    if (enable_i && !load_i) rest_q <= first_q ? (down_i ? load_value_i : ~load_value_i) : rest_q - 32'd1;
  end

  logic quiet;
  assign quiet = steady_q && same;

  `ASSERT(ReloadsInTheFirstClock, !enable_i || load_i || reloads == (first_q && reload_i))
  `ASSERT(RestIsWhatTheCountHasLeft, !quiet || first_q || rest_q == (down_i ? count_o : ~count_o))
  `ASSERT(WrapsWhenThePeriodEnds,
          !(quiet && enable_i && !load_i) || wraps_o == (!first_q && rest_q == '0))
  `ASSERT(ShowsTheWrappedValue, !wrapped_q || count_o == (down_q ? '1 : '0))
  `ASSERT(NoWrapWhileLoadingOrStopped, !wraps_o || (enable_i && !load_i))
  `ASSERT(StopFreezes, !stopped_q || count_o == count_q)
  `REACH(ShortestPeriodDown, quiet && wraps_o && down_i && load_value_i == '0)
  `REACH(ShortestPeriodUp, quiet && wraps_o && !down_i && load_value_i == '1)
  `REACH(PeriodOfFive, quiet && wraps_o && down_i && load_value_i == 32'd3)

endmodule

`default_nettype wire
