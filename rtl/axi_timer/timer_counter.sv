// The counter of one timer: counts up or down, and reloads one clock after it has wrapped.
//
// The wrapped value (all ones down, zero up) is visible for one clock before the reload, hence a steady period of
//   down: load_value_i + 2 clocks        up: (2^32 - 1 - load_value_i) + 2 clocks
// and a first wrap one clock earlier than that after a load. Without reload the wrapped value is held (one-shot).
`include "assert.svh"

module timer_counter (
  input  logic        clk_i,
  input  logic        rst_ni,        // synchronous; the count becomes 0
  input  logic        load_i,        // level: the count follows load_value_i and does not advance
  input  logic        enable_i,      // counts while 1; 0 freezes every state
  input  logic        down_i,
  input  logic        reload_i,      // leave the wrapped value by reloading
  input  logic [31:0] load_value_i,  // may change at any time; used by the next load or reload
  output logic [31:0] count_o,
  output logic        wraps_o        // the coming clock edge wraps the count
);

  logic wrapped_q;  // count_o shows the value it wrapped to

  assign wraps_o = enable_i && !load_i && !wrapped_q && count_o == (down_i ? '0 : '1);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      count_o   <= '0;
      wrapped_q <= 1'b0;
    end else if (load_i) begin
      count_o   <= load_value_i;
      wrapped_q <= 1'b0;
    end else if (enable_i) begin
      if (!wrapped_q) begin
        count_o   <= down_i ? count_o - 32'd1 : count_o + 32'd1;
        wrapped_q <= wraps_o;
      end else if (reload_i) begin
        count_o   <= load_value_i;
        wrapped_q <= 1'b0;
      end
    end
  end

  `ASSERT(WrappedShowsZeroOrAllOnes, !wrapped_q || count_o == '0 || count_o == '1)
  `ASSERT(WrapsOnlyFromTheEnd, !wraps_o || (down_i ? count_o == '0 : count_o == '1))
  `ASSERT(NoWrapWhileTheWrappedValueShows, !(wrapped_q && wraps_o))

endmodule
