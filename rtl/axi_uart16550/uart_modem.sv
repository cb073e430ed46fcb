// Modem lines of a UART: MSR, and the four outputs of MCR. Loopback connects the outputs to the inputs; the pins idle.
`include "assert.svh"

module uart_modem (
  input  logic       clk_i,
  input  logic       rst_ni,      // synchronous
  input  logic       awake_i,     // clock enable: 0 holds every flop
  input  logic [4:0] mcr_i,       // LOOP, OUT2, OUT1, RTS, DTR
  input  logic [3:0] lines_i,     // DCD, RI, DSR, CTS, active high; from sync_2ff and a flop with this reset
  input  logic       msr_read_i,  // one clock: clears the change bits
  output logic [7:0] msr_o,       // 7:4 levels, 3:0 changes since the last read
  output logic       filling_o,   // after reset: keep awake_i at 1
  output logic       event_o,     // the coming clock edge sets one of the change bits
  output logic [3:0] pins_no      // OUT2, OUT1, RTS, DTR: active low, from flops
);

  logic [3:0] lines, lines_q, changes_q;
  logic [3:0] filling_q;  // synchroniser, flop and lines_q hold no sample of the pins yet

  assign lines = !awake_i ? 4'd0 : mcr_i[4] ? {mcr_i[3], mcr_i[2], mcr_i[0], mcr_i[1]} : lines_i;
  assign msr_o = {lines_q, changes_q};

  // RI is reported at its end, the other lines at every change.
  logic [3:0] changes;
  assign changes = awake_i ? (lines ^ lines_q) & {1'b1, lines_q[2], 2'b11} : '0;
  assign event_o = awake_i ? filling_q == '0 && changes != '0 : 1'b0;
  assign filling_o = filling_q != '0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      lines_q   <= '0;
      changes_q <= '0;
      filling_q <= '1;
      pins_no   <= '1;
    end else if (awake_i) begin
      lines_q <= lines;
      pins_no <= mcr_i[4] ? 4'hF : ~mcr_i[3:0];
      if (filling_q != '0)            filling_q <= filling_q << 1;
      else if (msr_read_i || event_o) changes_q <= (msr_read_i ? 4'b0 : changes_q) | changes;
    end
  end

  `ASSERT(TheChangeOfARingIsItsEnd, !event_o || !changes[2] || !lines[2])

  `COVER(ChangeOfCts, event_o && changes[0])
  `COVER(ChangeOfDsr, event_o && changes[1])
  `COVER(EndOfARing, event_o && changes[2])
  `COVER(ChangeOfDcd, event_o && changes[3])
  `COVER(ChangeInTheClockOfTheRead, event_o && msr_read_i)

endmodule
