// Character time-out of uart_rx_status: exactly four character times after the last character or read, in ticks.
//
// A run to a time-out has at least 448 ticks, so the solver shows none. In place of it the proof counts the ticks since
// the last character or read, and compares their number with the counter of the module in every clock. Characters have
// no errors here: uart_interrupt_proof covers them.
`include "assert.svh"
`default_nettype none

module uart_rx_status_proof (
  input wire       clk_i,
  input wire       rst_ni,
  input wire       awake_i,
  input wire [1:0] length_i,
  input wire       stop_i,
  input wire       parity_i,
  input wire       fifo_on_i,
  input wire       flush_i,
  input wire       arrives_i,
  input wire       pop_i,
  input wire       waiting_i,
  input wire       lsr_read_i,
  input wire       tick_i
);

  logic [3:0] lsr_errors_o;
  logic       fifo_error_o, restart_o, timing_o, timeout_o;
  uart_rx_status u_dut (
    .*, .arriving_bad_i(1'b0), .overrun_i(1'b0), .fresh_i(1'b0), .top_errors_i(3'd0)
  );

  `RESET_FIRST

  // The FIFO: waiting_i begins with a character and ends with a read or a flush. FCR flushes if it changes the mode.
  logic after_q = 1'b0;
  logic waiting_q, fifo_on_q, flush_q, arrived_q, popped_q;
  always_ff @(posedge clk_i) begin
    after_q   <= rst_ni;
    waiting_q <= waiting_i;
    fifo_on_q <= fifo_on_i;
    flush_q   <= flush_i;
    arrived_q <= arrives_i && awake_i;
    popped_q  <= pop_i && awake_i;
  end
  `ASSUME(EmptyAfterResetAndFlush, (after_q && !flush_q) || !waiting_i)
  `ASSUME(WaitsFromACharacterOn, waiting_q || arrived_q || !waiting_i)
  `ASSUME(WaitsUntilARead, waiting_i || popped_q || flush_q || !after_q || !waiting_q)
  `ASSUME(TheModeChangesWithAFlush, fifo_on_i == fifo_on_q || flush_q || !after_q)
  `ASSUME(AccessesAreAwake, awake_i || !(flush_i || arrives_i || pop_i))
  `ASSUME(TicksWhileTiming, timing_o || !tick_i)

  // A character: start bit, 5 to 8 data bits, parity, and 1, 1.5 or 2 stop bits, of 16 ticks each.
  logic [9:0] character;
  assign character = 10'd16 * (10'd1 + 10'd5 + 10'(length_i) + 10'(parity_i)) +
                     (!stop_i ? 10'd16 : length_i == 2'd0 ? 10'd24 : 10'd32);

  logic       known_q, restarts, timeout_q;
  logic [9:0] limit_q, ticks_q;
  assign restarts = fifo_on_i && (arrives_i || pop_i);
  always_ff @(posedge clk_i) begin
    if (!rst_ni || flush_i) known_q <= 1'b0;
    else if (restarts) known_q <= 1'b1;
    if (restarts) {limit_q, ticks_q} <= {character << 2, 10'd0};
    else if (tick_i) ticks_q <= ticks_q + 10'd1;
    if (!rst_ni || flush_i || pop_i) timeout_q <= 1'b0;
    else if (tick_i && !restarts && ticks_q == limit_q - 10'd1) timeout_q <= 1'b1;
  end

  `ASSERT(TimesOutAfterFourCharacters, timeout_o == timeout_q)
  `ASSERT(RestartsWithCharactersAndReads, restart_o == restarts)
  `ASSERT(TimesWhileACharacterWaits, timing_o == (awake_i && fifo_on_i && waiting_i && !timeout_q))

  (* hierconn *) wire [9:0] \u_dut.ticks_q ;
  `ASSERT(CountsTheTicks, (!known_q || timeout_q ||
                           (\u_dut.ticks_q == limit_q - 10'd1 - ticks_q && ticks_q < limit_q)) &&
          (known_q || !(waiting_i && fifo_on_i)) && (fifo_on_i || !known_q))

  `REACH(AReadRestarts, known_q && ticks_q == 10'd3 && pop_i && tick_i)
  `REACH(TheLongestCharacter, known_q && limit_q == 10'd768 && ticks_q == 10'd2)

endmodule

`default_nettype wire
