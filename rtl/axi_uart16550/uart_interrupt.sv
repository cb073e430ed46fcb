// Interrupt of a UART: the enables (IER), the pending source with the highest priority (IIR bits 3:0) and the line.
//
// Codes of IIR, highest priority first: 6 line status, 4 received data, C character time-out, 2 THR empty, 0 modem,
// 1 none. THR empty is latched: THR has become empty, or IER bit 1 has been set while it was empty. It ends with a
// write of THR, and with a read of IIR that returns 2. The other sources are levels of other modules.
//
// event_i saves simulation time: the sources are evaluated only one clock after an event, or when IIR is read.
`include "assert.svh"

module uart_interrupt (
  input  logic       clk_i,
  input  logic       rst_ni,         // synchronous
  input  logic       awake_i,        // clock enable: 0 holds every flop
  input  logic       event_i,        // the coming clock edge may change a source or an enable; only while awake_i

  input  logic       ier_we_i,       // one clock: IER is written
  input  logic [3:0] wdata_i,        // valid with ier_we_i
  input  logic       iir_read_i,     // one clock: IIR is read

  input  logic [3:0] line_errors_i,  // LSR 4:1
  input  logic       fifo_on_i,      // 0: received data is pending while a character waits, regardless of trigger_i
  input  logic [1:0] trigger_i,      // FCR 7:6: level of the receive FIFO 1, 4, 8 or 14
  input  logic [4:0] rx_level_i,     // number of received characters
  input  logic       timeout_i,      // level: character time-out
  input  logic [3:0] modem_i,        // MSR 3:0
  input  logic       thr_empty_i,    // no character waits for the transmitter
  input  logic       thr_empties_i,  // the coming clock edge makes thr_empty_i 1
  input  logic       thr_write_i,    // one clock: THR is written

  output logic [3:0] ier_o,          // enables: modem, line status, THR empty, received data and time-out
  output logic [3:0] source_o,       // IIR 3:0, valid with iir_read_i
  output logic       changed_o,      // event_i in the previous clock: keep awake_i at 1
  output logic       irq_o           // level, one clock after the sources
);

  logic       thre_q;  // THR empty
  logic [4:0] trigger;
  logic       evaluates, at_trigger;

  always_comb begin
    case (trigger_i)
      2'd0:    trigger = 5'd1;
      2'd1:    trigger = 5'd4;
      2'd2:    trigger = 5'd8;
      default: trigger = 5'd14;
    endcase
  end
  assign evaluates  = changed_o || iir_read_i;
  assign at_trigger = evaluates ? (fifo_on_i ? rx_level_i >= trigger : rx_level_i != '0) : 1'b0;

  assign source_o = !evaluates                      ? 4'h1 :
                    ier_o[2] && line_errors_i != '0 ? 4'h6 :
                    ier_o[0] && at_trigger          ? 4'h4 :
                    ier_o[0] && timeout_i           ? 4'hC :
                    ier_o[1] && thre_q              ? 4'h2 :
                    ier_o[3] && modem_i != '0       ? 4'h0 : 4'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      changed_o <= 1'b0;
      irq_o     <= 1'b0;
    end else if (awake_i) begin
      changed_o <= event_i;
      if (changed_o) irq_o <= source_o != 4'h1;
    end
  end

  logic thre_enabled, thre_acknowledged;
  assign thre_enabled      = ier_we_i ? wdata_i[1] && !ier_o[1] && thr_empty_i : 1'b0;
  assign thre_acknowledged = awake_i ? thr_write_i || (iir_read_i && source_o == 4'h2) : 1'b0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      ier_o  <= '0;
      thre_q <= 1'b0;
    end else if (awake_i) begin
      if (ier_we_i) ier_o <= wdata_i;
      if (thr_empties_i || thre_enabled || thre_acknowledged) thre_q <= thr_empties_i || thre_enabled;
    end
  end

`ifdef ASSERT_ON
  logic irq_expected_q;
  always_ff @(posedge clk_i) begin
    irq_expected_q <= rst_ni && ((ier_o[2] && line_errors_i != '0) ||
                                 (ier_o[0] && (timeout_i || rx_level_i >= (fifo_on_i ? trigger : 5'd1))) ||
                                 (ier_o[1] && thre_q) || (ier_o[3] && modem_i != '0));
  end
`endif

  `ASSERT(IrqMissesNoChange, irq_o == irq_expected_q)
  `ASSERT(AWaitingThrIsNoEmptyThr, !thre_q || thr_empty_i)

  // Every interrupt source, and none.
  `COVER(LineStatusInterrupt, changed_o && source_o == 4'h6)
  `COVER(ReceiveInterrupt, changed_o && source_o == 4'h4)
  `COVER(TimeoutInterrupt, changed_o && source_o == 4'hC)
  `COVER(TransmitInterrupt, changed_o && source_o == 4'h2)
  `COVER(ModemInterrupt, changed_o && source_o == 4'h0)
  `COVER(InterruptEnds, irq_o && changed_o && source_o == 4'h1)

endmodule
