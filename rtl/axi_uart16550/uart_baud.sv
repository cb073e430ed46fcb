// Sixteenths of a bit: one tick every `divisor_i` clocks, counted from restart_i.
//
// It stands still while nobody runs it, so each user has its own and an idle UART switches no flop; the phase belongs
// to the character, not to a free-running clock.
`include "assert.svh"

module uart_baud (
  input  logic        clk_i,
  input  logic        rst_ni,      // synchronous
  input  logic        awake_i,     // 0: nothing happens in this clock, and nothing is evaluated
  input  logic [15:0] divisor_i,   // clocks of a tick
  input  logic        on_i,        // divisor_i is not 0; while 0 there is no tick
  input  logic        restart_i,   // the next tick comes divisor_i clocks after this one
  input  logic        run_i,
  output logic        tick_o       // one clock
);

  logic [15:0] count_q;  // clocks to the next tick

  always_comb begin
    tick_o = 1'b0;
    if (awake_i) tick_o = run_i && on_i && count_q == '0;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      count_q <= '0;
    end else if (awake_i) begin
      if (restart_i || tick_o)  count_q <= divisor_i - 16'd1;
      else if (run_i && on_i)   count_q <= count_q - 16'd1;
    end
  end

endmodule
