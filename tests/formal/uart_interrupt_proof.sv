// The interrupt of uart_core: sources, enables, priorities, what clears them, and the line, for all accesses and pins.
//
// LSR 4:1, the time-out, MSR 3:0 and the levels of the FIFOs are nets of the core. The proof states when each of them
// is cleared. A receiver that reports any character at any time replaces uart_rx, so that a few clocks show each error.
`include "assert.svh"
`default_nettype none

module uart_interrupt_proof (
  input wire        clk_i,
  input wire        rst_ni,
  input wire        access_i,
  input wire        rxd_i,
  input wire [3:0]  modem_i,
  input wire [31:0] wdata_i,
  input wire [3:0]  wstrb_i,
  input wire        rbr_we_i,
  input wire        rbr_re_i,
  input wire        ier_we_i,
  input wire        ier_re_i,
  input wire        iir_we_i,
  input wire        iir_re_i,
  input wire        lsr_re_i,
  input wire        msr_re_i,
  input wire [1:0]  lcr_length_i,
  input wire        lcr_stop_i,
  input wire        lcr_parity_i,
  input wire        lcr_even_i,
  input wire        lcr_stick_i,
  input wire        lcr_brk_i,
  input wire        lcr_dlab_i,
  input wire        mcr_dtr_i,
  input wire        mcr_rts_i,
  input wire        mcr_out1_i,
  input wire        mcr_out2_i,
  input wire        mcr_loop_i,
  input wire [7:0]  scr_value_i
);
  logic        txd_o, rts_no, dtr_no, out1_no, out2_no, irq_o, awake_o;
  logic [31:0] rbr_rdata_o, ier_rdata_o, iir_rdata_o, lsr_rdata_o, msr_rdata_o;
  uart_core_flat u_dut (.*);

  `RESET_FIRST

  // The register file: one access at a time; LCR and MCR change with a write.
  logic [8:0]  strobes;
  logic [12:0] settings, settings_q;
  logic        access_q;
  assign strobes  = {rbr_we_i, rbr_re_i, ier_we_i, ier_re_i, iir_we_i, iir_re_i, lsr_re_i, msr_re_i, 1'b0};
  assign settings = {lcr_length_i, lcr_stop_i, lcr_parity_i, lcr_even_i, lcr_stick_i, lcr_brk_i, lcr_dlab_i,
                     mcr_dtr_i, mcr_rts_i, mcr_out1_i, mcr_out2_i, mcr_loop_i};
  always_ff @(posedge clk_i) begin
    settings_q <= settings;
    access_q   <= access_i;
  end
  `ASSUME(OneStrobe, (strobes & (strobes - 9'd1)) == '0)
  `ASSUME(StrobesAreAccesses, access_i || strobes == '0)
  `ASSUME(SettingsAreWritten, access_q || settings == settings_q)

  // Nets of the core. `flatten` connects them to the nets of the same names.
  (* hierconn *) wire [3:0] \u_dut.u_flat.line_errors , \u_dut.u_flat.u_modem.changes ;
  (* hierconn *) wire [4:0] \u_dut.u_flat.rx_level , \u_dut.u_flat.tx_level ;
  (* hierconn *) wire [7:0] \u_dut.u_flat.msr ;
  (* hierconn *) wire [1:0] \u_dut.u_flat.trigger_q ;
  (* hierconn *) wire [2:0] \u_dut.u_flat.rx_top_errors ;
  (* hierconn *) wire \u_dut.u_flat.timeout , \u_dut.u_flat.fifo_on_q , \u_dut.u_flat.rx_fresh ;
  (* hierconn *) wire \u_dut.u_flat.rx_flush , \u_dut.u_flat.rx_overrun , \u_dut.u_flat.modem_event ;
  (* hierconn *) wire \u_dut.u_flat.changed_q ;
  (* hierconn *) wire \u_dut.u_flat.u_interrupt.thre_q , \u_dut.u_flat.activity_q ;
  logic [3:0] errors, changes;
  logic [4:0] rx_level, tx_level;
  logic       timeout, fifo_on;
  assign errors   = \u_dut.u_flat.line_errors ;
  assign changes  = \u_dut.u_flat.msr [3:0];
  assign rx_level = \u_dut.u_flat.rx_level ;
  assign tx_level = \u_dut.u_flat.tx_level ;
  assign timeout  = \u_dut.u_flat.timeout ;
  assign fifo_on  = \u_dut.u_flat.fifo_on_q ;

  // Accesses to the registers without DLAB.
  logic ier_write, thr_write, rbr_read, iir_read;
  assign ier_write = ier_we_i && wstrb_i[0] && !lcr_dlab_i;
  assign thr_write = rbr_we_i && wstrb_i[0] && !lcr_dlab_i;
  assign rbr_read  = rbr_re_i && !lcr_dlab_i;
  assign iir_read  = iir_re_i && !lcr_dlab_i;

  // THR empty: set when the last waiting character is taken, or when it is enabled while nothing waits. It is cleared
  // by a write of THR and by a read of IIR that returns it.
  logic [3:0] ier_q, code;
  logic [4:0] tx_level_q, depth;
  logic       latched_q, thre, pending_q;
  logic [4:0] pending;  // highest priority first
  assign thre    = latched_q || (tx_level == '0 && tx_level_q != '0);
  assign depth   = !fifo_on || \u_dut.u_flat.trigger_q == 2'd0 ? 5'd1 : \u_dut.u_flat.trigger_q == 2'd1 ? 5'd4 :
                   \u_dut.u_flat.trigger_q == 2'd2 ? 5'd8 : 5'd14;
  assign pending = {ier_q[2] && errors != '0, ier_q[0] && rx_level >= depth, ier_q[0] && timeout, ier_q[1] && thre,
                    ier_q[3] && changes != '0};
  assign code    = pending[4] ? 4'h6 : pending[3] ? 4'h4 : pending[2] ? 4'hC : pending[1] ? 4'h2 : pending[0] ? 4'h0 :
                   4'h1;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) {ier_q, tx_level_q, latched_q, pending_q} <= '0;
    else begin
      if (ier_write) ier_q <= wdata_i[3:0];
      if (ier_write && wdata_i[1] && !ier_q[1] && tx_level == '0) latched_q <= 1'b1;
      else latched_q <= thre && !thr_write && !(iir_read && code == 4'h2);
      tx_level_q <= tx_level;
      pending_q  <= pending != '0;
    end
  end

  `ASSERT(IirHasTheHighestPriority, !iir_read || iir_rdata_o == {24'd0, {2{fifo_on}}, 2'd0, code})
  (* hierconn *) wire [3:0] \u_dut.u_flat.ier ;
  `ASSERT(IerIsWrittenAndReadsBack, \u_dut.u_flat.ier == ier_q &&
          (!(ier_re_i && !lcr_dlab_i) || ier_rdata_o == {28'd0, ier_q}))
  `ASSERT(TheLineFollowsAClockLater, irq_o == pending_q)

  // What clears the other sources, and that nothing else does.
  logic       after_q, lsr_read_q, msr_read_q, rbr_read_q, flush_q, overrun_q, timeout_q;
  logic [3:0] errors_q, changes_q, lines_q;
  always_ff @(posedge clk_i) begin
    after_q    <= rst_ni;
    lsr_read_q <= lsr_re_i;
    msr_read_q <= msr_re_i;
    rbr_read_q <= rbr_read;
    flush_q    <= \u_dut.u_flat.rx_flush ;
    overrun_q  <= \u_dut.u_flat.rx_overrun ;
    timeout_q  <= timeout;
    errors_q   <= errors;
    changes_q  <= changes;
    lines_q    <= \u_dut.u_flat.modem_event ? \u_dut.u_flat.u_modem.changes : '0;
  end
  `ASSERT(LsrAndMsrReadTheSources, (!lsr_re_i || lsr_rdata_o[5:0] == {tx_level == '0, errors, rx_level != '0}) &&
          (!msr_re_i || msr_rdata_o[3:0] == changes))
  `ASSERT(ReadingLsrClearsTheErrors, !after_q || errors == ((lsr_read_q ? '0 : errors_q) | {3'd0, overrun_q} |
          (\u_dut.u_flat.rx_fresh ? {\u_dut.u_flat.rx_top_errors , 1'b0} : 4'd0)))
  `ASSERT(ReadingRbrClearsTheTimeOut, !after_q || (rbr_read_q || flush_q ? !timeout : timeout || !timeout_q))
  `ASSERT(ReadingMsrClearsTheChanges, !after_q || changes == ((msr_read_q ? '0 : changes_q) | lines_q))

  // Invariants of flops that no port shows.
  (* hierconn *) wire [3:0] \u_dut.u_flat.u_modem.filling_q , \u_dut.u_flat.u_tx.left_q ;
  (* hierconn *) wire \u_dut.u_flat.u_tx.stopping_q ;
  `ASSERT(ThreIsLatched, \u_dut.u_flat.u_interrupt.thre_q == thre)
  `ASSERT(TheLineIsLateOnlyAfterAnEvent, \u_dut.u_flat.changed_q || irq_o == (pending != '0))
  (* hierconn *) wire [4:0] \u_dut.u_flat.pins_q ;
  (* hierconn *) wire [3:0] \u_dut.u_flat.u_modem.lines_q ;
  (* hierconn *) wire \u_dut.u_flat.pins_changed_q ;
  logic [3:0] lines;
  logic       filling;
  assign lines   = mcr_loop_i ? {mcr_out2_i, mcr_out1_i, mcr_dtr_i, mcr_rts_i} : \u_dut.u_flat.pins_q [3:0];
  assign filling = \u_dut.u_flat.u_modem.filling_q != '0;
  `ASSERT(AwakeAfterEachEvent,
          (\u_dut.u_flat.activity_q || !(\u_dut.u_flat.pins_changed_q || \u_dut.u_flat.changed_q || filling)) &&
          (\u_dut.u_flat.pins_changed_q || \u_dut.u_flat.changed_q || filling ||
           \u_dut.u_flat.u_modem.lines_q == lines) &&
          (!filling || changes == '0) && (!\u_dut.u_flat.u_tx.stopping_q || \u_dut.u_flat.u_tx.left_q == '0))

  // The number of errors behind the oldest character, for LSR 7.
  (* hierconn *) wire [3:0] \u_dut.u_flat.u_rx_fifo.read_q ;
  (* hierconn *) wire [4:0] \u_dut.u_flat.u_rx_status.bad_q ;
  (* hierconn *) wire [10:0] \u_dut.u_flat.u_rx_fifo.entry_q[0] , \u_dut.u_flat.u_rx_fifo.entry_q[1] ;
  (* hierconn *) wire [10:0] \u_dut.u_flat.u_rx_fifo.entry_q[2] , \u_dut.u_flat.u_rx_fifo.entry_q[3] ;
  (* hierconn *) wire [10:0] \u_dut.u_flat.u_rx_fifo.entry_q[4] , \u_dut.u_flat.u_rx_fifo.entry_q[5] ;
  (* hierconn *) wire [10:0] \u_dut.u_flat.u_rx_fifo.entry_q[6] , \u_dut.u_flat.u_rx_fifo.entry_q[7] ;
  (* hierconn *) wire [10:0] \u_dut.u_flat.u_rx_fifo.entry_q[8] , \u_dut.u_flat.u_rx_fifo.entry_q[9] ;
  (* hierconn *) wire [10:0] \u_dut.u_flat.u_rx_fifo.entry_q[10] , \u_dut.u_flat.u_rx_fifo.entry_q[11] ;
  (* hierconn *) wire [10:0] \u_dut.u_flat.u_rx_fifo.entry_q[12] , \u_dut.u_flat.u_rx_fifo.entry_q[13] ;
  (* hierconn *) wire [10:0] \u_dut.u_flat.u_rx_fifo.entry_q[14] , \u_dut.u_flat.u_rx_fifo.entry_q[15] ;
  logic [15:0] bad;
  logic [2:0]  entry_errors [16];
  assign entry_errors[0] = \u_dut.u_flat.u_rx_fifo.entry_q[0] [10:8];
  assign entry_errors[1] = \u_dut.u_flat.u_rx_fifo.entry_q[1] [10:8];
  assign entry_errors[2] = \u_dut.u_flat.u_rx_fifo.entry_q[2] [10:8];
  assign entry_errors[3] = \u_dut.u_flat.u_rx_fifo.entry_q[3] [10:8];
  assign entry_errors[4] = \u_dut.u_flat.u_rx_fifo.entry_q[4] [10:8];
  assign entry_errors[5] = \u_dut.u_flat.u_rx_fifo.entry_q[5] [10:8];
  assign entry_errors[6] = \u_dut.u_flat.u_rx_fifo.entry_q[6] [10:8];
  assign entry_errors[7] = \u_dut.u_flat.u_rx_fifo.entry_q[7] [10:8];
  assign entry_errors[8] = \u_dut.u_flat.u_rx_fifo.entry_q[8] [10:8];
  assign entry_errors[9] = \u_dut.u_flat.u_rx_fifo.entry_q[9] [10:8];
  assign entry_errors[10] = \u_dut.u_flat.u_rx_fifo.entry_q[10] [10:8];
  assign entry_errors[11] = \u_dut.u_flat.u_rx_fifo.entry_q[11] [10:8];
  assign entry_errors[12] = \u_dut.u_flat.u_rx_fifo.entry_q[12] [10:8];
  assign entry_errors[13] = \u_dut.u_flat.u_rx_fifo.entry_q[13] [10:8];
  assign entry_errors[14] = \u_dut.u_flat.u_rx_fifo.entry_q[14] [10:8];
  assign entry_errors[15] = \u_dut.u_flat.u_rx_fifo.entry_q[15] [10:8];
  for (genvar i = 0; i < 16; i++) begin : gen_entry
    logic [3:0] place;  // 0 is the oldest character, whose errors count only while it is new
    assign place  = 4'(i) - \u_dut.u_flat.u_rx_fifo.read_q ;
    assign bad[i] = entry_errors[i] != '0 && {1'b0, place} < rx_level && (place != '0 || \u_dut.u_flat.rx_fresh );
  end
  logic [4:0] number;
  always_comb begin
    number = '0;
    for (int i = 0; i < 16; i++) number = number + 5'(bad[i]);
  end
  `ASSERT(CountsTheErrorsInTheFifo, \u_dut.u_flat.u_rx_status.bad_q == number)
  `ASSERT(Lsr7IsAnErrorInTheFifo, !lsr_re_i || lsr_rdata_o[7] == (fifo_on && (number != '0 || errors[3:1] != '0)))

  `REACH(AllButTheTimeOutArePending, pending == 5'b11011 && iir_read)
  `REACH(ThreIsAcknowledged, iir_read && code == 4'h2 && irq_o)
  `REACH(AnErrorArrivesWithTheRead, after_q && lsr_read_q && errors[1] && errors_q[2])
  `REACH(AChangeMeetsTheReadOfMsr, after_q && msr_read_q && lines_q != '0 && changes_q != '0)
  `REACH(TwoErrorsWait, number == 5'd2)

endmodule

// Any receiver: it starts while idle and then reports characters, with any errors, until it is idle again.
module uart_rx (
  input  wire        clk_i,
  input  wire        rst_ni,
  input  wire        awake_i,
  input  wire  [1:0] length_i,
  input  wire        parity_i,
  input  wire        even_i,
  input  wire        stick_i,
  input  wire        on_i,
  input  wire        tick_i,
  input  wire        line_i,
  input  wire        hold_i,
  output logic       start_o,
  output logic       running_o,
  output logic       idle_o,
  output logic       push_o,
  output logic [7:0] data_o,
  output logic       parity_error_o,
  output logic       framing_error_o,
  output logic       break_o
);
  (* anyseq *) logic starts, runs, ends, reports;
  (* anyseq *) logic [10:0] character;
  logic busy_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) busy_q <= 1'b1;
    else if (awake_i) busy_q <= start_o || (busy_q && !ends);
  end
  assign start_o   = awake_i && !busy_q && starts;
  assign running_o = awake_i && busy_q && runs;
  assign push_o    = awake_i && busy_q && reports;
  assign idle_o    = !busy_q && !start_o;
  assign {break_o, framing_error_o, parity_error_o, data_o} = push_o ? character : '0;
endmodule

`default_nettype wire
