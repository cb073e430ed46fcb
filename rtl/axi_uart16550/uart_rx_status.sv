// What software sees of the receive FIFO besides its data: the error bits of LSR and the character timeout.
//
// PE, FE and BI travel through the FIFO with their character and are set when it becomes the oldest one, OE at once;
// all four stay until LSR is read. In the clock in which a character becomes the oldest, lsr_errors_o already shows its
// errors, so that no read sees the character without them.
`include "assert.svh"

module uart_rx_status (
  input  logic       clk_i,
  input  logic       rst_ni,          // synchronous
  input  logic       awake_i,         // 0: nothing happens in this clock, and nothing is evaluated
  input  logic [1:0] length_i,        // LCR: a character time
  input  logic       stop_i,
  input  logic       parity_i,
  input  logic       fifo_on_i,       // 0: 16450, without timeout and fifo_error_o
  input  logic       flush_i,

  input  logic       arrives_i,       // a character has been received, and may find room
  input  logic       arriving_bad_i,  // one of its errors is set
  input  logic       overrun_i,       // no room; only with arrives_i
  input  logic       pop_i,           // the oldest character is read
  input  logic       fresh_i,         // the oldest character has just become that
  input  logic [2:0] top_errors_i,    // its BI, FE, PE
  input  logic       waiting_i,       // the FIFO is not empty
  input  logic       lsr_read_i,

  output logic [3:0] lsr_errors_o,    // BI, FE, PE, OE: LSR 4:1, cleared after lsr_read_i
  output logic       fifo_error_o,    // LSR 7, with lsr_read_i: an error is unread or waits behind the oldest character

  // Four character times without a character in or out set timeout_o, until a character is read.
  input  logic       tick_i,          // sixteenth of a bit while timing_o, in phase with restart_o
  output logic       restart_o,
  output logic       timing_o,
  output logic       timeout_o
);

  logic [3:0] errors_q;
  logic [4:0] bad_q;  // characters with errors in the FIFO that have not been the oldest yet

  logic bad_in, bad_out;
  assign bad_in       = arrives_i ? arriving_bad_i && !(overrun_i && fifo_on_i) : 1'b0;
  assign bad_out      = fresh_i ? top_errors_i != '0 : 1'b0;
  assign lsr_errors_o = fresh_i ? errors_q | {top_errors_i, 1'b0} : errors_q;
  assign fifo_error_o = lsr_read_i ? fifo_on_i && (bad_q != '0 || errors_q[3:1] != '0) : 1'b0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      errors_q <= '0;
      bad_q    <= '0;
    end else if (awake_i && (arrives_i || fresh_i || lsr_read_i || flush_i)) begin
      errors_q <= (lsr_read_i ? 4'b0 : lsr_errors_o) | {3'b0, overrun_i};
      if (flush_i)                bad_q <= '0;
      else if (bad_in != bad_out) bad_q <= bad_in ? bad_q + 5'd1 : bad_q - 5'd1;
    end
  end

  // Four times start, data, parity and stop, in ticks: 64 for each bit, 32 for half a stop bit.
  logic [9:0] ticks_q;  // ticks to the timeout after the next one

  assign restart_o = awake_i ? fifo_on_i && (arrives_i || pop_i) : 1'b0;
  assign timing_o  = awake_i ? fifo_on_i && waiting_i && !timeout_o : 1'b0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      ticks_q   <= '0;
      timeout_o <= 1'b0;
    end else if (awake_i) begin
      if (restart_o) begin
        ticks_q <= ((10'd7 + 10'(length_i) + 10'(parity_i)) << 6) - 10'd1 +
                   (!stop_i ? 10'd0 : length_i == '0 ? 10'd32 : 10'd64);
      end else if (tick_i) begin
        ticks_q <= ticks_q - 10'd1;
        if (ticks_q == '0) timeout_o <= 1'b1;
      end
      if (pop_i || flush_i) timeout_o <= 1'b0;
    end
  end

  `ASSERT(BadCharactersFitInTheFifo, bad_q <= 5'd16)
  `ASSERT(NoBadCharacterLeavesThatDidNotEnter, !bad_out || bad_q != '0)
  `ASSERT(TimeoutOnlyWithACharacter, !timeout_o || waiting_i)

  `COVER(Timeout, timeout_o)
  `COVER(TimeoutEndsWithTheRead, timeout_o && pop_i)
  `COVER(OverrunLatched, errors_q[0])
  `COVER(ErrorBelowTheTop, bad_q != '0 && !fresh_i)

endmodule
