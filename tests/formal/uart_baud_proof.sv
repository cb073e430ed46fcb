// uart_baud: a tick every `divisor_i` clocks, the first one that many clocks after a restart. The divisor is
// sampled at a restart and at every tick.
`include "assert.svh"
`default_nettype none

module uart_baud_proof (
  input wire        clk_i,
  input wire        rst_ni,
  input wire        awake_i,
  input wire [15:0] divisor_i,
  input wire        restart_i,
  input wire        run_i
);

  logic on_i, tick_o;
  assign on_i = divisor_i != '0;
  uart_baud u_dut (.*);

  `RESET_FIRST

  // Clocks until the next tick. Only a clock with `counts` is one of them.
  logic        known_q;  // there was a restart or a tick
  logic [16:0] left_q;
  logic        counts;
  assign counts = awake_i && run_i && on_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) known_q <= 1'b0;
    else if (awake_i && (restart_i || tick_o)) known_q <= on_i;  // a divisor of 0 is no distance

    if (awake_i && (restart_i || tick_o)) left_q <= {1'b0, divisor_i};
    else if (counts) left_q <= left_q - 17'd1;
  end

  (* hierconn *) wire [15:0] \u_dut.count_q ;
  `ASSERT(TicksAfterAsManyClocks, !(known_q && counts) || tick_o == (left_q == 17'd1))
  `ASSERT(TicksOnlyWhileItCounts, !tick_o || counts)
  `ASSERT(CountIsTheRest, !known_q || (left_q != '0 && {1'b0, \u_dut.count_q } == left_q - 17'd1))

  `REACH(TicksInEveryClock, known_q && tick_o && divisor_i == 16'd1 && tick_q)
  `REACH(TicksEveryThreeClocks, known_q && tick_o && divisor_i == 16'd3 && left_q == 17'd1)
  logic tick_q;
  always_ff @(posedge clk_i) tick_q <= rst_ni && tick_o;

endmodule

`default_nettype wire
