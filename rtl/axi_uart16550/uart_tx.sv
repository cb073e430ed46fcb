// Transmitter of a UART: start bit, 5 to 8 data bits (lowest first), parity, stop. There is no gap between characters.
//
// Every bit lasts 16 ticks. The stop lasts 16 ticks, or with stop_i 32 (24 after 5 data bits). The format is sampled at
// the start of a character.
`include "assert.svh"

module uart_tx (
  input  logic       clk_i,
  input  logic       rst_ni,    // synchronous; the line idles high
  input  logic       awake_i,   // clock enable: 0 holds every flop
  input  logic [1:0] length_i,  // LCR: number of data bits - 5
  input  logic       stop_i,    // LCR: long stop
  input  logic       parity_i,  // LCR: a parity bit follows the data
  input  logic       even_i,    // LCR: even parity
  input  logic       stick_i,   // LCR: the parity bit is the inverse of even_i
  input  logic       on_i,      // a character may begin
  input  logic       tick_i,    // 16 per bit while busy_o, in phase with pop_o
  input  logic       valid_i,   // data_i is valid
  input  logic [7:0] data_i,
  output logic       pop_o,     // the coming clock edge accepts data_i
  output logic       done_o,    // the coming clock edge ends a stop bit
  output logic       busy_o,    // a character is in progress: enables the ticks
  output logic       serial_o   // from a flop
);

  logic [8:0] shift_q;     // data and parity bits not yet sent
  logic [3:0] left_q;      // bits in shift_q
  logic       stopping_q;  // the stop bit is being sent
  logic [4:0] ticks_q;     // ticks until the end of this bit, minus one
  logic [4:0] stop_q;      // ticks of the stop bit, minus one

  always_comb begin
    done_o = 1'b0;
    pop_o = 1'b0;
    if (awake_i) begin
      done_o = tick_i && stopping_q && ticks_q == '0;
      pop_o = valid_i && on_i && (!busy_o || done_o);
    end
  end

  // The frame of data_i, evaluated only in the clock of pop_o. Odd parity makes the number of ones odd.
  logic [3:0] length;
  logic [7:0] data;
  logic       parity;
  logic [8:0] frame;
  assign length = pop_o ? 4'd5 + 4'(length_i) : '0;
  assign data   = pop_o ? data_i & (8'hFF >> (2'd3 - length_i)) : '0;
  assign parity = pop_o ? (stick_i ? !even_i : (^data) ^ !even_i) : 1'b0;
  assign frame  = pop_o ? {1'b0, data} | ({8'b0, parity} << length) : '0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      busy_o     <= 1'b0;
      serial_o   <= 1'b1;
      shift_q    <= '0;
      left_q     <= '0;
      stopping_q <= 1'b0;
      ticks_q    <= '0;
      stop_q     <= '0;
    end else if (pop_o) begin
      busy_o     <= 1'b1;
      serial_o   <= 1'b0;
      shift_q    <= frame;
      left_q     <= length + 4'(parity_i);
      stopping_q <= 1'b0;
      ticks_q    <= 5'd15;
      stop_q     <= !stop_i ? 5'd15 : length_i == '0 ? 5'd23 : 5'd31;
    end else if (tick_i) begin
      if (ticks_q != '0) begin
        ticks_q <= ticks_q - 5'd1;
      end else if (left_q != '0) begin
        serial_o <= shift_q[0];
        shift_q  <= shift_q >> 1;
        left_q   <= left_q - 4'd1;
        ticks_q  <= 5'd15;
      end else if (!stopping_q) begin
        serial_o   <= 1'b1;
        stopping_q <= 1'b1;
        ticks_q    <= stop_q;
      end else begin
        busy_o     <= 1'b0;
        stopping_q <= 1'b0;
      end
    end
  end

  `ASSERT(TicksOnlyWhileBusy, !tick_i || busy_o)
  `ASSERT(IdleLineIsHigh, busy_o || serial_o)
  `ASSERT(StopBitIsHigh, !stopping_q || serial_o)

  `COVER(FromIdle, pop_o && !busy_o)
  `COVER(BackToBack, pop_o && busy_o)
  `COVER(ToIdle, done_o && !pop_o)
  `COVER(OneStopBit, done_o && stop_q == 5'd15)
  `COVER(OneAndAHalfStopBits, done_o && stop_q > 5'd15 && stop_q < 5'd31)
  `COVER(TwoStopBits, done_o && stop_q == 5'd31)

endmodule
