// The counter of one timer. It counts up or down and reloads one clock after the end of its period.
//
// The wrapped value (all ones down, zero up) is visible for one clock before the reload. The steady period is
//   down: load_value_i + 2 clocks        up: (2^32 - 1 - load_value_i) + 2 clocks
// The first period after a load is one clock shorter. Without reload the wrapped value is held (one-shot).
// In a cascade the wrapped 64-bit value is visible for three clocks, so the period is two clocks longer.
`include "assert.svh"

module timer_counter (
  input  logic        clk_i,
  input  logic        rst_ni,        // synchronous; the count becomes 0
  input  logic        load_i,        // level: the count follows load_value_i and does not advance
  input  logic        restart_i,     // load_i for one clock; it suppresses an end of the period in that clock
  input  logic        step_i,        // clock enable: the count advances; 0 holds the whole state
  input  logic        down_i,        // count direction, 1 is down
  input  logic        free_i,        // free-running: continues after every roll-over, and from a held wrapped value
  input  logic        reload_i,      // a reload replaces the wrapped value
  input  logic        follow_i,      // overrides reload_i: only restart_i replaces the wrapped value
  input  logic [31:0] load_value_i,  // may change at any time; used by the next load or reload

  input  logic        lower_i,       // lower half of a cascade: a period ends only if the upper half is at its end
  input  logic [31:0] upper_count_i, // count of the upper half

  input  logic        upper_i,       // upper half of a cascade: of the inputs above only load and restart act
  input  logic        carry_i,       // count enable of the upper half
  input  logic        upper_down_i,  // count direction of the upper half, 1 is down

  output logic [31:0] count_o,       // present count
  output logic        wraps_o,       // the coming clock edge rolls the count over
  output logic        expires_o,     // the coming clock edge ends the period
  output logic        reloads_o      // the coming clock edge replaces the wrapped value
);

  // Number of clocks for which the wrapped value is visible.
  localparam logic [1:0] Show = 2'd1, ShowCascade = 2'd3;

  logic [1:0] left_q;  // clocks until a reload replaces the wrapped value; 0 while counting

  // Branches save simulation time: for a stopped timer the simulator evaluates step_i only.
  always_comb begin
    wraps_o   = 1'b0;
    expires_o = 1'b0;
    reloads_o = 1'b0;
    if (step_i && !load_i && !restart_i && !upper_i) begin
      if (left_q != '0 && !free_i) begin
        reloads_o = reload_i && !follow_i && left_q == 2'd1;
      end else if (count_o == (down_i ? '0 : '1)) begin
        wraps_o   = 1'b1;
        expires_o = !free_i && (!lower_i || upper_count_i == (down_i ? '0 : '1));
      end
    end
  end

  // The state before the clock edge, read before any of it is assigned.
  /* verilator tracing_off */
  logic [31:0] count;
  logic [1:0]  left;
  /* verilator tracing_on */

  /* verilator lint_off BLKSEQ */
  always_ff @(posedge clk_i) begin
    count = count_o;
    left  = left_q;

    if (!rst_ni) begin
      count_o <= '0;
      left_q  <= '0;
    end else if (load_i || restart_i) begin
      count_o <= load_value_i;
      left_q  <= '0;
    end else if (upper_i) begin
      if (carry_i) begin
        count_o <= upper_down_i ? count - 32'd1 : count + 32'd1;
        left_q  <= '0;
      end
    end else if (step_i) begin
      if (left == '0 || free_i) begin
        count_o <= down_i ? count - 32'd1 : count + 32'd1;
        left_q  <= expires_o ? (lower_i ? ShowCascade : Show) : '0;
      end else if (left != 2'd1) begin
        left_q <= left - 2'd1;
      end else if (reload_i && !follow_i) begin
        count_o <= load_value_i;
        left_q  <= '0;
      end
    end
  end
  /* verilator lint_on BLKSEQ */

  `ASSERT(WrappedShowsZeroOrAllOnes, left_q == '0 || count_o == '0 || count_o == '1)
  `ASSERT(WrapsOnlyFromTheEnd, !wraps_o || (down_i ? count_o == '0 : count_o == '1))
  `ASSERT(ExpiresOnceUntilReloaded, !(left_q != '0 && expires_o))

  `COVER(WrapsDown, expires_o && down_i)
  `COVER(WrapsUp, expires_o && !down_i)
  `COVER(Reloads, reloads_o)
  `COVER(OneShotStands, step_i && left_q == 2'd1 && !reload_i)
  `COVER(LoadHoldsTheCount, load_i && step_i)
  `COVER(CascadeExpires, expires_o && lower_i)
  `COVER(LowerWrapsWithoutExpiring, wraps_o && lower_i && !expires_o && !free_i)
  `COVER(UpperCarries, upper_i && carry_i)
  `COVER(CaptureCounterWraps, wraps_o && free_i)

endmodule
