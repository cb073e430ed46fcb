// Receiver of a UART. It detects the start bit, samples every bit in its middle (majority of ticks 7, 8 and 9 of 16)
// and reports each character with its errors. It checks only the first stop bit.
//
// A start bit that is high in its middle was a glitch and is ignored. After a missing stop bit (framing error, or break
// if all bits were low) the receiver waits for a high line before it detects the next start bit.
//
// Reception ends in the middle of the stop bit, so that the next start bit of a faster sender is not missed. hold_i
// delays the report. In loopback a character is reported when the transmitter has finished, because software that has
// read its own character assumes that the transmitter is empty.
`include "assert.svh"

module uart_rx (
  input  logic       clk_i,
  input  logic       rst_ni,     // synchronous; then the receiver waits for a high line
  input  logic       awake_i,    // clock enable: 0 holds every flop
  input  logic [1:0] length_i,   // LCR: number of data bits - 5. The format is sampled at the start of a character
  input  logic       parity_i,   // LCR: a parity bit follows the data
  input  logic       even_i,     // LCR: even parity
  input  logic       stick_i,    // LCR: the parity bit is the inverse of even_i
  input  logic       on_i,       // a character may begin
  input  logic       tick_i,     // 16 per bit while running_o, in phase with start_o
  input  logic       line_i,     // synchronised
  input  logic       hold_i,     // level: delays the report of a received character
  output logic       start_o,    // the coming clock edge begins a character
  output logic       running_o,  // a character is in progress: enables the ticks
  output logic       idle_o,     // no character is in progress and none begins
  output logic       push_o,     // one clock: data_o and the errors are valid
  output logic [7:0] data_o,     // upper bits of short characters are 0
  output logic       parity_error_o,  // valid with push_o
  output logic       framing_error_o,  // no stop bit; valid with push_o
  output logic       break_o     // all bits were low; data_o is 0 and framing_error_o is 1
);

  localparam logic [2:0] Idle = 3'd0, Start = 3'd1, Bits = 3'd2, Stop = 3'd3, Deliver = 3'd4, AwaitHigh = 3'd5;

  logic [2:0] state_q;
  logic [1:0] length_q;
  logic       parity_q, even_q, stick_q;
  logic [3:0] ticks_q;   // ticks since the start of this bit
  logic [3:0] left_q;    // data and parity bits not yet received
  logic [8:0] shift_q;   // received bits, newest at the top
  logic       stop_q;    // level of the stop bit
  logic [1:0] sample_q;  // levels at the last two ticks

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
  assign idle_o = state_q == Idle && !start_o;

  // The character: the received bits, shifted down to bit 0. Evaluated only in the clock of push_o.
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

  // Every state transition.
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
