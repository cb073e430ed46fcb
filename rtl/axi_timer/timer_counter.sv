// The counter of one timer: counts up or down, and reloads one clock after the end of its period.
//
// The wrapped value (all ones down, zero up) is visible for one clock before the reload, hence a steady period of
//   down: load_value_i + 2 clocks        up: (2^32 - 1 - load_value_i) + 2 clocks
// and a first end one clock earlier than that after a load. Without reload the wrapped value is held (one-shot).
// The 64-bit value of a cascade shows for three clocks, so that its period is two clocks longer.
`include "assert.svh"

module timer_counter (
  input  logic        clk_i,
  input  logic        rst_ni,        // synchronous; the count becomes 0
  input  logic        load_i,        // level: the count follows load_value_i and does not advance
  input  logic        restart_i,     // as load_i for one clock: what would have expired in it does not
  input  logic        step_i,        // advances in this clock; 0 freezes every state
  input  logic        down_i,
  input  logic        free_i,        // runs on through every roll-over, and from a held wrapped value too
  input  logic        reload_i,      // leave the wrapped value by reloading
  input  logic        follow_i,      // do not: restart_i does it
  input  logic [31:0] load_value_i,  // may change at any time; used by the next load or reload

  input  logic        lower_i,       // lower half of a cascade: a period ends only if the upper half is at its end too
  input  logic [31:0] upper_count_i, // count of the upper half

  input  logic        upper_i,       // upper half of a cascade: of the above only load and restart count
  input  logic        carry_i,       // the upper half counts in this clock
  input  logic        upper_down_i,  // and in this direction

  output logic [31:0] count_o,
  output logic        wraps_o,       // the coming clock edge rolls the count over
  output logic        expires_o,     // and ends the period by it
  output logic        reloads_o      // the coming clock edge replaces the wrapped value
);

  // Clocks for which the wrapped value shows.
  localparam logic [1:0] Show = 2'd1, ShowCascade = 2'd3;

  logic [1:0] left_q;  // clocks for which the wrapped value still shows before a reload; 0 while counting

  // In branches, because a simulated clock costs what it evaluates: a timer that stands still only looks at step_i.
  logic at_end;

  always_comb begin
    at_end    = 1'b0;
    wraps_o   = 1'b0;
    expires_o = 1'b0;
    reloads_o = 1'b0;
    if (step_i) begin
      at_end = count_o == (down_i ? '0 : '1);
      if (!load_i && !restart_i && !upper_i) begin
        if (left_q != '0 && !free_i) begin
          reloads_o = reload_i && !follow_i && left_q == 2'd1;
        end else if (at_end) begin
          wraps_o   = 1'b1;
          expires_o = !free_i && (!lower_i || upper_count_i == (down_i ? '0 : '1));
        end
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      count_o <= '0;
      left_q  <= '0;
    end else if (load_i || restart_i) begin
      count_o <= load_value_i;
      left_q  <= '0;
    end else if (upper_i) begin
      if (carry_i) begin
        count_o <= upper_down_i ? count_o - 32'd1 : count_o + 32'd1;
        left_q  <= '0;
      end
    end else if (step_i) begin
      if (left_q == '0 || free_i) begin
        count_o <= down_i ? count_o - 32'd1 : count_o + 32'd1;
        left_q  <= expires_o ? (lower_i ? ShowCascade : Show) : '0;
      end else if (left_q != 2'd1) begin
        left_q <= left_q - 2'd1;
      end else if (reload_i && !follow_i) begin
        count_o <= load_value_i;
        left_q  <= '0;
      end
    end
  end

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
