// Status of the receive FIFO: the error bits of LSR and the character time-out.
//
// PE, FE and BI are stored in the FIFO with their character and set when it becomes the oldest one. OE is set at once.
// All four stay set until LSR is read. lsr_errors_o includes the errors of a character from the clock in which it
// becomes the oldest, so that software never reads a character without its errors.
`include "assert.svh"

module uart_rx_status (
  input  logic       clk_i,
  input  logic       rst_ni,          // synchronous
  input  logic       awake_i,         // clock enable: 0 holds every flop
  input  logic [1:0] length_i,        // LCR: format, which sets the duration of a character
  input  logic       stop_i,
  input  logic       parity_i,
  input  logic       fifo_on_i,       // 0: 16450 mode, without timeout_o and fifo_error_o
  input  logic       flush_i,         // one clock: empties the FIFO

  input  logic       arrives_i,       // one clock: a character has been received
  input  logic       arriving_bad_i,  // the received character has an error; valid with arrives_i
  input  logic       overrun_i,       // the FIFO is full; only with arrives_i
  input  logic       pop_i,           // the oldest character is read
  input  logic       fresh_i,         // the last clock edge brought a new oldest character
  input  logic [2:0] top_errors_i,    // BI, FE, PE of the oldest character
  input  logic       waiting_i,       // the FIFO is not empty
  input  logic       lsr_read_i,      // one clock: LSR is read

  output logic [3:0] lsr_errors_o,    // BI, FE, PE, OE: LSR 4:1, cleared after lsr_read_i
  output logic       fifo_error_o,    // LSR 7, valid with lsr_read_i: an unread error, or one of a later character

  // timeout_o is set after four character times in which no character was received or read. A read clears it.
  input  logic       tick_i,          // 16 per bit while timing_o, in phase with restart_o
  output logic       restart_o,       // restarts the ticks
  output logic       timing_o,        // the time-out is running: enables the ticks
  output logic       timeout_o        // level, see above
);

  logic [3:0] errors_q;
  logic [4:0] bad_q;  // number of characters with errors behind the oldest character

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

  // Four times the length of a character in ticks: 64 for each bit, 32 for half a stop bit.
  logic [9:0] ticks_q;  // ticks until the time-out, minus one

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
