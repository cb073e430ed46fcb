// uart_tx against the frame of a character: level and duration of every bit, for every format and every character, and
// whatever happens to the format and the data after the start.
`include "assert.svh"
`default_nettype none

module uart_tx_proof (
  input wire       clk_i,
  input wire       rst_ni,
  input wire       awake_i,
  input wire [1:0] length_i,
  input wire       stop_i,
  input wire       parity_i,
  input wire       even_i,
  input wire       stick_i,
  input wire       on_i,
  input wire       tick_i,
  input wire       valid_i,
  input wire [7:0] data_i
);

  logic pop_o, done_o, busy_o, serial_o;
  uart_tx u_dut (.*);

  `RESET_FIRST

  `ASSUME(TicksOnlyInACharacter, !tick_i || (busy_o && awake_i))

  // The frame: a start bit, `length` data bits from bit 0, a parity bit, and the stop.
  logic [8:0] frame_q;  // data and parity bits, in the order of the line
  logic [3:0] bits_q;   // number of them
  logic [4:0] stop_q;   // ticks of the stop, minus one
  logic       ones;
  logic [8:0] frame;
  always_comb begin
    ones  = 1'b0;
    frame = '0;
    for (int i = 0; i < 8; i++) begin
      if (i < 5 + 32'(length_i)) begin
        frame[i] = data_i[i];
        ones     = ones ^ data_i[i];
      end
    end
    // Stick parity is the inverse of `even`. Even parity makes the number of ones even.
    if (parity_i) frame[5+32'(length_i)] = stick_i ? !even_i : even_i ? ones : !ones;
  end

  // Position in the frame: part_q is 0 in the start bit, k in the k-th bit of the frame, bits_q + 1 in the stop.
  logic       active_q;
  logic [3:0] part_q;
  logic [4:0] ticks_q;  // ticks since the start of this part
  logic       stopping, ends;
  assign stopping = part_q > bits_q;
  assign ends     = active_q && tick_i && ticks_q == (stopping ? stop_q : 5'd15);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) active_q <= 1'b0;
    else if (pop_o) active_q <= 1'b1;
    else if (ends && stopping) active_q <= 1'b0;

    if (pop_o) begin
      part_q  <= '0;
      ticks_q <= '0;
      frame_q <= frame;
      bits_q  <= 4'd5 + 4'(length_i) + 4'(parity_i);
      stop_q  <= !stop_i ? 5'd15 : length_i == 2'd0 ? 5'd23 : 5'd31;  // 1, 1.5 or 2 bits
    end else if (ends) begin
      part_q  <= part_q + 4'd1;
      ticks_q <= '0;
    end else if (tick_i) ticks_q <= ticks_q + 5'd1;
  end

  logic expected;
  assign expected = !active_q || stopping || (part_q != '0 && 1'(frame_q >> (part_q - 4'd1)));
  `ASSERT(LineIsTheFrame, serial_o == expected)
  `ASSERT(BusyInTheFrame, busy_o == active_q)
  `ASSERT(DoneAtTheEndOfTheStop, done_o == (ends && stopping))
  `ASSERT(TakesWithoutAGap, pop_o == (awake_i && valid_i && on_i && (!active_q || (ends && stopping))))

  // Invariants of the state.
  (* hierconn *) wire [8:0] \u_dut.shift_q ;
  (* hierconn *) wire [3:0] \u_dut.left_q ;
  (* hierconn *) wire       \u_dut.stopping_q ;
  (* hierconn *) wire [4:0] \u_dut.ticks_q , \u_dut.stop_q ;
  for (genvar i = 0; i < 9; i++) begin : gen_bit
    `ASSERT(ShiftIsTheRest, !active_q || i >= \u_dut.left_q || \u_dut.shift_q [i] == 1'((frame_q >> part_q) >> i))
  end
  `ASSERT(LeftIsTheRest, !active_q || \u_dut.left_q == (stopping ? 4'd0 : bits_q - part_q))
  `ASSERT(StopIsTheLastPart, \u_dut.stopping_q == (active_q && stopping))
  `ASSERT(StopLasts, !active_q || \u_dut.stop_q == stop_q)
  `ASSERT(TicksAreTheRest, !active_q || \u_dut.ticks_q == (stopping ? stop_q : 5'd15) - ticks_q)
  `ASSERT(TicksAreInThePart, !active_q || ticks_q <= (stopping ? stop_q : 5'd15))
  `ASSERT(PartIsInTheFrame, !active_q || (part_q <= bits_q + 4'd1 && bits_q <= 4'd9))
  `ASSERT(StopIsAStop, !active_q || stop_q == 5'd15 || stop_q == 5'd23 || stop_q == 5'd31)

  `REACH(SendsAOne, serial_o && active_q && part_q == 4'd1)
  `REACH(StartsWithOddParity, active_q && bits_q == 4'd9 && frame_q == 9'h1FF)
  `REACH(StartsWithALongStop, active_q && stop_q == 5'd23 && frame_q == 9'h015)

endmodule

`default_nettype wire
