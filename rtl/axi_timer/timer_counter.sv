// The counter of one timer: counts up or down, and reloads one clock after the end of its period.
//
// The wrapped value (all ones down, zero up) is visible for one clock before the reload, hence a steady period of
//   down: load_value_i + 2 clocks        up: (2^32 - 1 - load_value_i) + 2 clocks
// and a first end one clock earlier than that after a load. Without reload the wrapped value is held (one-shot).
`include "assert.svh"

module timer_counter (
  input  logic        clk_i,
  input  logic        rst_ni,        // synchronous; the count becomes 0
  input  logic        load_i,        // level: the count follows load_value_i and does not advance
  input  logic        restart_i,     // as load_i for one clock: what would have expired in it does not
  input  logic        step_i,        // advances in this clock; 0 freezes every state
  input  logic        down_i,
  input  logic        free_i,        // runs on through every roll-over, and on from a held wrapped value
  input  logic        last_i,        // a roll-over in this clock ends the period; 0 runs on through it
  input  logic        reload_i,      // leave the wrapped value by reloading
  input  logic [1:0]  linger_i,      // clocks beyond the first that the wrapped value shows before a reload
  input  logic [31:0] load_value_i,  // may change at any time; used by the next load or reload
  output logic [31:0] count_o,
  output logic        at_end_o,      // the next step rolls over
  output logic        wraps_o,       // the coming clock edge rolls the count over
  output logic        expires_o,     // and ends the period by it
  output logic        reloads_o      // the coming clock edge replaces the wrapped value
);

  logic       wrapped_q;  // count_o shows the value with which the period ended
  logic [1:0] linger_q;   // clocks for which it still has to show before a reload

  assign at_end_o  = count_o == (down_i ? '0 : '1);
  assign wraps_o   = step_i && at_end_o && (!wrapped_q || free_i) && !load_i && !restart_i;
  assign expires_o = wraps_o && last_i && !free_i;
  assign reloads_o = wrapped_q && step_i && reload_i && linger_q == '0 && !free_i && !load_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      count_o   <= '0;
      wrapped_q <= 1'b0;
      linger_q  <= '0;
    end else if (load_i || restart_i) begin
      count_o   <= load_value_i;
      wrapped_q <= 1'b0;
    end else if (step_i) begin
      if (!wrapped_q || free_i) begin
        count_o   <= down_i ? count_o - 32'd1 : count_o + 32'd1;
        wrapped_q <= expires_o;
        if (expires_o) linger_q <= linger_i;
      end else if (linger_q != '0) begin
        linger_q <= linger_q - 2'd1;
      end else if (reload_i) begin
        count_o   <= load_value_i;
        wrapped_q <= 1'b0;
      end
    end
  end

  `ASSERT(WrappedShowsZeroOrAllOnes, !wrapped_q || count_o == '0 || count_o == '1)
  `ASSERT(WrapsOnlyFromTheEnd, !wraps_o || (down_i ? count_o == '0 : count_o == '1))
  `ASSERT(ExpiresOnceUntilReloaded, !(wrapped_q && expires_o))

endmodule
