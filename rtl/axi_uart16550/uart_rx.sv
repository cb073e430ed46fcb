// Receiver of a UART: finds the start bit, samples every bit in its middle (majority of the ticks 7, 8 and 9 of 16),
// and hands each character on with its errors. The first stop bit alone is checked.
//
// A start bit that is high in its middle was a glitch: nothing is received. After a missing stop bit (framing error;
// break, if everything was low) the next start bit is looked for when the line has been high.
//
// Reception ends in the middle of the stop bit, so that a faster sender's next start bit is not missed. hold_i delays
// the delivery: in loopback the character arrives when the transmitter has finished, because software that has
// received its own character takes the transmitter to be empty.
`include "assert.svh"

module uart_rx (
  input  logic       clk_i,
  input  logic       rst_ni,     // synchronous; waits for a high line
  input  logic       awake_i,    // 0: nothing happens in this clock, and nothing is evaluated
  input  logic [1:0] length_i,   // LCR: data bits less 5. A character keeps the format that it began with
  input  logic       parity_i,
  input  logic       even_i,
  input  logic       stick_i,
  input  logic       on_i,       // may begin a character
  input  logic       tick_i,     // sixteenth of a bit while running_o, in phase with start_o
  input  logic       line_i,     // in this clock domain
  input  logic       hold_i,     // a received character waits
  output logic       start_o,    // the coming clock edge begins a character
  output logic       running_o,
  output logic       resting_o,  // neither is a character under way nor does one begin
  output logic       push_o,     // one clock: data_o and the errors are a character
  output logic [7:0] data_o,     // upper bits of short characters are 0
  output logic       parity_error_o,
  output logic       framing_error_o,
  output logic       break_o     // start, data, parity and stop were low: data_o is 0, framing_error_o is set
);

  localparam logic [2:0] Idle = 3'd0, Start = 3'd1, Bits = 3'd2, Stop = 3'd3, Deliver = 3'd4, AwaitHigh = 3'd5;

  logic [2:0] state_q;
  logic [1:0] length_q;
  logic       parity_q, even_q, stick_q;
  logic [3:0] ticks_q;   // ticks of this bit so far
  logic [3:0] left_q;    // data and parity bits still to come
  logic [8:0] shift_q;   // the bits so far, newest at the top
  logic       stop_q;    // level of the stop bit
  logic [1:0] sample_q;  // the last two ticks

  logic middle, level;
  assign middle = awake_i ? tick_i && ticks_q == 4'd8 : 1'b0;
  assign level  = middle ? (sample_q[0] && sample_q[1]) || (line_i && (sample_q[0] || sample_q[1])) : 1'b0;

  always_comb begin
    start_o   = 1'b0;
    running_o = 1'b0;
    push_o    = 1'b0;
    if (awake_i) begin
      start_o   = state_q == Idle && !line_i && on_i;
      running_o = state_q == Start || state_q == Bits || state_q == Stop;
      push_o    = state_q == Deliver && !hold_i;
    end
  end
  assign resting_o = state_q == Idle && !start_o;

  // The character, evaluated only in the clock of push_o: the bits received, moved down to bit 0.
  logic [8:0] received;
  logic       parity;
  assign received        = push_o ? shift_q >> (4'd4 - 4'(length_q) - 4'(parity_q)) : '0;
  assign data_o          = push_o ? received[7:0] & (8'hFF >> (2'd3 - length_q)) : '0;
  assign parity          = push_o ? (received >> (4'd5 + 4'(length_q))) != '0 : 1'b0;
  assign framing_error_o = push_o ? !stop_q : 1'b0;
  assign break_o         = push_o ? framing_error_o && received == '0 : 1'b0;
  // Odd parity makes the number of ones odd; stick parity is the inverse of `even`.
  assign parity_error_o  = push_o ? parity_q && !break_o &&
                                    parity != (stick_q ? !even_q : (^data_o) ^ !even_q) : 1'b0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q  <= AwaitHigh;
      {length_q, parity_q, even_q, stick_q} <= '0;
      ticks_q  <= '0;
      left_q   <= '0;
      shift_q  <= '0;
      stop_q   <= 1'b0;
      sample_q <= '0;
    end else if (start_o) begin
      state_q  <= Start;
      length_q <= length_i;
      parity_q <= parity_i;
      even_q   <= even_i;
      stick_q  <= stick_i;
      left_q   <= 4'd5 + 4'(length_i) + 4'(parity_i);
      ticks_q  <= '0;
    end else if (tick_i) begin
      ticks_q  <= ticks_q + 4'd1;
      sample_q <= {sample_q[0], line_i};
      if (middle) begin
        case (state_q)
          Start: state_q <= level ? Idle : Bits;
          Bits: begin
            shift_q <= {level, shift_q[8:1]};
            left_q  <= left_q - 4'd1;
            if (left_q == 4'd1) state_q <= Stop;
          end
          default: begin
            stop_q  <= level;
            state_q <= Deliver;
          end
        endcase
      end
    end else if (state_q > Stop) begin
      if (push_o) state_q <= stop_q ? Idle : AwaitHigh;
      else if (state_q == AwaitHigh && line_i) state_q <= Idle;
    end
  end

  `ASSERT(TicksOnlyWhileRunning, !tick_i || running_o)
  `ASSERT(ABreakIsAnEmptyCharacterWithoutStop, !break_o || (push_o && data_o == '0 && framing_error_o))

  // Every transition.
  `COVER(IdleToStart, $past(state_q) == Idle && state_q == Start)
  `COVER(StartToIdle, $past(state_q) == Start && state_q == Idle)
  `COVER(StartToBits, $past(state_q) == Start && state_q == Bits)
  `COVER(BitsToStop, $past(state_q) == Bits && state_q == Stop)
  `COVER(StopToDeliver, $past(state_q) == Stop && state_q == Deliver)
  `COVER(DeliverToIdle, $past(state_q) == Deliver && state_q == Idle)
  `COVER(DeliverToAwaitHigh, $past(state_q) == Deliver && state_q == AwaitHigh)
  `COVER(AwaitHighToIdle, $past(state_q) == AwaitHigh && state_q == Idle)
  `COVER(DeliverWaitsForTheLoop, state_q == Deliver && hold_i)
  `COVER(ParityError, push_o && parity_error_o)
  `COVER(FramingErrorWithoutBreak, push_o && framing_error_o && !break_o)
  `COVER(Break, push_o && break_o)

endmodule
