// uart_rx against a receiver that stores the level of every bit: what it reports for every line, format and length of a
// tick, and whatever happens to the format after the start.
//
// The ticks of a character are numbered from 0 at its start bit. The majority of the ticks 6, 7 and 8 of 16 decides a
// bit; these are its seventh to ninth sixteenth.
`include "assert.svh"
`default_nettype none

module uart_rx_proof (
  input wire       clk_i,
  input wire       rst_ni,
  input wire       awake_i,
  input wire [1:0] length_i,
  input wire       parity_i,
  input wire       even_i,
  input wire       stick_i,
  input wire       on_i,
  input wire       tick_i,
  input wire       line_i,
  input wire       hold_i
);

  logic       start_o, running_o, idle_o, push_o, parity_error_o, framing_error_o, break_o;
  logic [7:0] data_o;
  uart_rx u_dut (.*);

  `RESET_FIRST

  `ASSUME(TicksOnlyInACharacter, !tick_i || (running_o && awake_i))
  `ASSUME(AsleepOnlyAtRest, awake_i || idle_o)

  // The character in progress: bit_q is 0 in the start bit, k in the k-th bit after it.
  localparam logic [1:0] Waits = 2'd0, Receives = 2'd1, Reports = 2'd2, NeedsHigh = 2'd3;
  logic [1:0] state_q;
  logic [3:0] bit_q, tick_q;
  logic [1:0] early_q;   // levels at ticks 6 and 7
  logic [9:0] levels_q;  // decided levels, [0] the first bit after the start bit
  logic [1:0] length_q;
  logic       parity_q, even_q, stick_q;
  logic       begins, decides, level;
  logic [3:0] bits;      // data and parity bits of this character
  assign begins  = state_q == Waits && awake_i && on_i && !line_i;
  assign decides = tick_i && tick_q == 4'd8;
  assign level   = 2'(early_q[0]) + 2'(early_q[1]) + 2'(line_i) >= 2'd2;
  assign bits    = 4'd5 + 4'(length_q) + 4'(parity_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) state_q <= NeedsHigh;
    else if (begins) state_q <= Receives;
    else if (state_q == Receives && decides) begin
      if (bit_q == '0 && level) state_q <= Waits;  // no start bit
      else if (bit_q == bits + 4'd1) state_q <= Reports;
    end
    else if (state_q == Reports && awake_i && !hold_i) state_q <= levels_q[bits] ? Waits : NeedsHigh;
    else if (state_q == NeedsHigh && line_i) state_q <= Waits;

    if (begins) begin
      {bit_q, tick_q} <= '0;
      levels_q        <= '0;
      {length_q, parity_q, even_q, stick_q} <= {length_i, parity_i, even_i, stick_i};
    end else if (tick_i) begin
      tick_q <= tick_q + 4'd1;
      if (tick_q == 4'd6) early_q[0] <= line_i;
      if (tick_q == 4'd7) early_q[1] <= line_i;
      if (decides) begin
        bit_q <= bit_q + 4'd1;
        if (bit_q != '0) levels_q <= levels_q | (10'(level) << (bit_q - 4'd1));
      end
    end
  end

  // What the levels mean.
  logic [7:0] data;
  logic       ones, parity_level, wrong;
  logic       all_low;
  always_comb begin
    data    = '0;
    ones    = 1'b0;
    all_low = 1'b1;
    for (int i = 0; i < 8; i++) if (i < 5 + 32'(length_q)) data[i] = levels_q[i];
    for (int i = 0; i < 8; i++) ones = ones ^ data[i];
    for (int i = 0; i < 10; i++) if (i <= 32'(bits)) all_low = all_low && !levels_q[i];
  end
  assign parity_level = levels_q[4'd5+4'(length_q)];
  assign wrong        = parity_q && parity_level != (stick_q ? !even_q : even_q ? ones : !ones);

  `ASSERT(StartsAtALowLine, start_o == begins)
  `ASSERT(RunsInTheCharacter, running_o == (state_q == Receives && awake_i))
  `ASSERT(IdleBetweenCharacters, idle_o == (state_q == Waits && !begins))
  `ASSERT(ReportsEachCharacterOnce, push_o == (state_q == Reports && awake_i && !hold_i))
  `ASSERT(DataAreTheLevels, !push_o || data_o == data)
  `ASSERT(FramingErrorWithoutAStopBit, !push_o || framing_error_o == !levels_q[bits])
  `ASSERT(BreakWhenAllIsLow, !push_o || break_o == all_low)
  `ASSERT(ParityErrorWhenItIsWrong, !push_o || parity_error_o == (wrong && !all_low))

  // Invariants of the state.
  (* hierconn *) wire [2:0] \u_dut.state_q ;
  (* hierconn *) wire [1:0] \u_dut.length_q , \u_dut.sample_q ;
  (* hierconn *) wire       \u_dut.parity_q , \u_dut.even_q , \u_dut.stick_q , \u_dut.stop_q ;
  (* hierconn *) wire [3:0] \u_dut.ticks_q , \u_dut.left_q ;
  (* hierconn *) wire [8:0] \u_dut.shift_q ;
  logic in_bits;
  assign in_bits = bit_q != '0 && bit_q <= bits;
  `ASSERT(StateIsThePlace, \u_dut.state_q == (state_q == Waits ? 3'd0 : state_q == Reports ? 3'd4 :
          state_q == NeedsHigh ? 3'd5 : bit_q == '0 ? 3'd1 : in_bits ? 3'd2 : 3'd3))
  `ASSERT(FormatIsThatOfTheStart, state_q == Waits || state_q == NeedsHigh ||
          {\u_dut.length_q , \u_dut.parity_q , \u_dut.even_q , \u_dut.stick_q } ==
          {length_q, parity_q, even_q, stick_q})
  `ASSERT(BitIsInTheCharacter, !(state_q == Receives) || bit_q <= bits + 4'd1)
  `ASSERT(TicksAreCounted, state_q != Receives || \u_dut.ticks_q == tick_q)
  `ASSERT(LeftIsTheRest, !(state_q == Receives && bit_q <= bits) ||
          \u_dut.left_q == (bit_q == '0 ? bits : bits + 4'd1 - bit_q))
  `ASSERT(SamplesAreTheLastTwo, state_q != Receives || ((tick_q != 4'd7 || \u_dut.sample_q [0] == early_q[0]) &&
          (tick_q != 4'd8 || \u_dut.sample_q == {early_q[0], early_q[1]})))
  for (genvar i = 0; i < 9; i++) begin : gen_level
    `ASSERT(ShiftHoldsTheLevels, !(state_q == Reports ? i < bits : state_q == Receives && i + 1 < bit_q && i < bits) ||
            1'(\u_dut.shift_q >> (state_q == Reports || bit_q > bits ? 4'd9 - bits + 4'(i) :
                                  4'd9 - (bit_q - 4'd1) + 4'(i))) == levels_q[i])
  end
  `ASSERT(LaterLevelsAreOpen, state_q != Receives || (bit_q == '0 ? levels_q : levels_q >> (bit_q - 4'd1)) == '0)
  `ASSERT(StopIsTheLastLevel, state_q != Reports || \u_dut.stop_q == levels_q[bits])

  `REACH(NoStartBit, running_o && decides && bit_q == '0 && level)
  `REACH(SecondBit, running_o && bit_q == 4'd2 && levels_q[0])

endmodule

`default_nettype wire
