// Baud rate generator: one tick every `divisor_i` clocks, counted from restart_i. A bit lasts 16 ticks.
//
// It runs only while run_i is 1. Each user has its own generator, so an idle UART switches no flop, and the phase of
// the ticks follows the character.
`include "assert.svh"

module uart_baud (
  input  logic        clk_i,
  input  logic        rst_ni,      // synchronous
  input  logic        awake_i,     // clock enable: 0 holds every flop
  input  logic [15:0] divisor_i,   // clocks per tick
  input  logic        on_i,        // divisor_i is not 0; 0 stops the ticks
  input  logic        restart_i,   // the next tick comes divisor_i clocks after this clock
  input  logic        run_i,       // level: the ticks run
  output logic        tick_o       // high for one clock
);

  logic [15:0] count_q;  // clocks until the next tick

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
