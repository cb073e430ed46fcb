// Core of a 16550A: byte registers, two FIFOs, transmitter, receiver, modem lines and one interrupt. The register file
// stores LCR, MCR and SCR.
//
// irq_o is a level that follows the registers one clock later. Every process is inactive in a clock in which no
// character is in progress or waits for its time-out, no modem line changes and no register is accessed.
`include "assert.svh"
`include "axi_uart16550_reg_types.svh"

module uart_core (
  input  logic       clk_i,
  input  logic       rst_ni,      // synchronous

  input  logic       access_i,    // one cycle per access: a register of the block is written or read

  /* verilator tracing_off */
  input  axi_uart16550_reg2hw_t reg2hw_i,
  output axi_uart16550_hw2reg_t hw2reg_o,
  /* verilator tracing_on */

  input  logic       rxd_i,       // synchronised
  input  logic [3:0] modem_i,     // synchronised, active high: DCD, RI, DSR, CTS
  output logic       txd_o,       // serial line, idle high
  output logic       rts_no,
  output logic       dtr_no,
  output logic       out1_no,
  output logic       out2_no,
  output logic       irq_o,       // level, active high
  output logic       awake_o      // clock request; 0: the next edge changes no flop, unless a register is accessed
);

  // Strobes: a write has an effect only if it enables byte 0. rdata is the data of a read in the same clock and 0
  // otherwise.
  logic       rbr_we, rbr_re, ier_we, ier_re, iir_we, iir_re, lsr_re, msr_re, unused;
  logic [7:0] wdata, rdata, lcr;
  logic [4:0] mcr;
  assign rbr_we             = reg2hw_i.rbr_we && reg2hw_i.wstrb[0];
  assign rbr_re             = reg2hw_i.rbr_re;
  assign ier_we             = reg2hw_i.ier_we && reg2hw_i.wstrb[0];
  assign ier_re             = reg2hw_i.ier_re;
  assign iir_we             = reg2hw_i.iir_we && reg2hw_i.wstrb[0];
  assign iir_re             = reg2hw_i.iir_re;
  assign lsr_re             = reg2hw_i.lsr_re;
  assign msr_re             = reg2hw_i.msr_re;
  assign wdata              = reg2hw_i.wdata[7:0];
  assign lcr                = {reg2hw_i.lcr_dlab, reg2hw_i.lcr_brk, reg2hw_i.lcr_stick, reg2hw_i.lcr_even,
                               reg2hw_i.lcr_parity, reg2hw_i.lcr_stop, reg2hw_i.lcr_length};
  assign mcr                = {reg2hw_i.mcr_loop, reg2hw_i.mcr_out2, reg2hw_i.mcr_out1, reg2hw_i.mcr_rts,
                               reg2hw_i.mcr_dtr};
  assign unused             = ^{reg2hw_i.wdata[31:8], reg2hw_i.wstrb[3:1], reg2hw_i.scr_value};
  assign hw2reg_o.rbr_rdata = {24'd0, rdata};
  assign hw2reg_o.ier_rdata = {24'd0, rdata};
  assign hw2reg_o.iir_rdata = {24'd0, rdata};
  assign hw2reg_o.lsr_rdata = {24'd0, rdata};
  assign hw2reg_o.msr_rdata = {24'd0, rdata};

  logic dlab, loopback;
  assign dlab     = lcr[7];
  assign loopback = mcr[4];

  // Clock enable: 1 in a clock with an access, in the clock after an access or a pin change, and until all is idle.
  logic       awake, activity, activity_q;
  logic [4:0] pins_q;  // synchronised: rxd, modem lines
  logic       rxd;
  logic [3:0] modem_lines;
  assign {rxd, modem_lines} = pins_q;

  // Divisor latch.
  logic [15:0] divisor_q;
  logic        baud_on_q;      // the divisor is not 0
  logic        baud_loaded_q;  // the divisor has just been written: the bit in progress continues with it

  // FCR. A write with bit 0 = 0 changes no other bit.
  logic       fifo_on_q, dma_q;
  logic [1:0] trigger_q;
  logic       rx_flush, tx_flush;
  assign rx_flush = iir_we ? wdata[0] != fifo_on_q || (wdata[0] && wdata[1]) : 1'b0;
  assign tx_flush = iir_we ? wdata[0] != fifo_on_q || (wdata[0] && wdata[2]) : 1'b0;

  // Transmitter.
  logic       tx_push, tx_pop, tx_tick, tx_done, tx_busy, tx_serial, tx_empties;
  logic [4:0] tx_level;
  logic [7:0] tx_data;
  assign tx_push = rbr_we && !dlab;

  uart_fifo #(.Width(8)) u_tx_fifo (
    .clk_i,
    .rst_ni,
    .awake_i(awake),
    .single_i (!fifo_on_q),
    .flush_i  (tx_flush),
    .push_i   (tx_push),
    .data_i   (wdata),
    .pop_i    (tx_pop),
    .top_o    (tx_data),
    .level_o  (tx_level),
    .fresh_o  (),
    .overrun_o(),
    .empties_o(tx_empties)
  );

  uart_baud u_tx_baud (
    .clk_i,
    .rst_ni,
    .awake_i(awake),
    .divisor_i(divisor_q),
    .on_i     (baud_on_q),
    .restart_i(tx_pop || baud_loaded_q),
    .run_i    (tx_busy),
    .tick_o   (tx_tick)
  );

  uart_tx u_tx (
    .clk_i,
    .rst_ni,
    .awake_i(awake),
    .length_i(lcr[1:0]),
    .stop_i  (lcr[2]),
    .parity_i(lcr[3]),
    .even_i  (lcr[4]),
    .stick_i (lcr[5]),
    .on_i    (baud_on_q),
    .tick_i  (tx_tick),
    .valid_i (tx_level != '0),
    .data_i  (tx_data),
    .pop_o   (tx_pop),
    .done_o  (tx_done),
    .busy_o  (tx_busy),
    .serial_o(tx_serial)
  );

  // Break and loopback change the pin only.
  always_ff @(posedge clk_i) begin
    if (!rst_ni)    txd_o <= 1'b1;
    else if (awake) txd_o <= loopback || (tx_serial && !lcr[6]);
  end

  // Receiver.
  logic       rx_start, rx_running, rx_idle, rx_tick, rx_push, rx_pop, rx_overrun, rx_fresh;
  logic       rx_parity_error, rx_framing_error, rx_break;
  logic [4:0] rx_level;
  logic [7:0] rx_data, rx_top;
  logic [2:0] rx_top_errors;
  assign rx_pop = rbr_re && !dlab;

  uart_baud u_rx_baud (
    .clk_i,
    .rst_ni,
    .awake_i(awake),
    .divisor_i(divisor_q),
    .on_i     (baud_on_q),
    .restart_i(rx_start || baud_loaded_q),
    .run_i    (rx_running),
    .tick_o   (rx_tick)
  );

  uart_rx u_rx (
    .clk_i,
    .rst_ni,
    .awake_i(awake),
    .length_i       (lcr[1:0]),
    .parity_i       (lcr[3]),
    .even_i         (lcr[4]),
    .stick_i        (lcr[5]),
    .on_i           (baud_on_q),
    .tick_i         (rx_tick),
    .line_i         (loopback ? tx_serial : rxd),
    .hold_i         (loopback && tx_busy && !tx_done),
    .start_o        (rx_start),
    .running_o      (rx_running),
    .idle_o         (rx_idle),
    .push_o         (rx_push),
    .data_o         (rx_data),
    .parity_error_o (rx_parity_error),
    .framing_error_o(rx_framing_error),
    .break_o        (rx_break)
  );

  uart_fifo #(.Width(11)) u_rx_fifo (
    .clk_i,
    .rst_ni,
    .awake_i(awake),
    .single_i (!fifo_on_q),
    .flush_i  (rx_flush),
    .push_i   (rx_push),
    .data_i   ({rx_break, rx_framing_error, rx_parity_error, rx_data}),
    .pop_i    (rx_pop),
    .top_o    ({rx_top_errors, rx_top}),
    .level_o  (rx_level),
    .fresh_o  (rx_fresh),
    .overrun_o(rx_overrun),
    .empties_o()
  );

  logic       rx_waiting, fifo_error, timeout, timing, timeout_tick, timeout_restart;
  logic [3:0] line_errors;
  assign rx_waiting = rx_level != '0;

  uart_rx_status u_rx_status (
    .clk_i,
    .rst_ni,
    .awake_i(awake),
    .length_i      (lcr[1:0]),
    .stop_i        (lcr[2]),
    .parity_i      (lcr[3]),
    .fifo_on_i     (fifo_on_q),
    .flush_i       (rx_flush),
    .arrives_i     (rx_push),
    .arriving_bad_i(rx_break || rx_framing_error || rx_parity_error),
    .overrun_i     (rx_overrun),
    .pop_i         (rx_pop),
    .fresh_i       (rx_fresh),
    .top_errors_i  (rx_top_errors),
    .waiting_i     (rx_waiting),
    .lsr_read_i    (lsr_re),
    .lsr_errors_o  (line_errors),
    .fifo_error_o  (fifo_error),
    .tick_i        (timeout_tick),
    .restart_o     (timeout_restart),
    .timing_o      (timing),
    .timeout_o     (timeout)
  );

  uart_baud u_timeout_baud (
    .clk_i,
    .rst_ni,
    .awake_i(awake),
    .divisor_i(divisor_q),
    .on_i     (baud_on_q),
    .restart_i(timeout_restart || baud_loaded_q),
    .run_i    (timing),
    .tick_o   (timeout_tick)
  );

  // Modem lines.
  logic [7:0] msr;
  logic       modem_event, modem_filling;
  uart_modem u_modem (
    .clk_i,
    .rst_ni,
    .awake_i(awake),
    .mcr_i     (mcr),
    .lines_i   (modem_lines),
    .msr_read_i(msr_re),
    .msr_o     (msr),
    .filling_o (modem_filling),
    .event_o   (modem_event),
    .pins_no   ({out2_no, out1_no, rts_no, dtr_no})
  );

  // Interrupts. `changed` covers every event that can change a source.
  logic [3:0] ier, source;
  logic       changed, changed_q;
  assign changed = awake ? access_i || rx_push || rx_fresh || timeout_tick || tx_pop || modem_event : 1'b0;

  uart_interrupt u_interrupt (
    .clk_i,
    .rst_ni,
    .awake_i(awake),
    .event_i      (changed),
    .ier_we_i     (ier_we && !dlab),
    .wdata_i      (wdata[3:0]),
    .iir_read_i   (iir_re && !dlab),
    .line_errors_i(line_errors),
    .fifo_on_i    (fifo_on_q),
    .trigger_i    (trigger_q),
    .rx_level_i   (rx_level),
    .timeout_i    (timeout),
    .modem_i      (msr[3:0]),
    .thr_empty_i  (tx_level == '0),
    .thr_empties_i(tx_empties),
    .thr_write_i  (tx_push),
    .ier_o        (ier),
    .source_o     (source),
    .changed_o    (changed_q),
    .irq_o
  );

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      divisor_q     <= '0;
      baud_on_q     <= 1'b0;
      baud_loaded_q <= 1'b0;
      fifo_on_q     <= 1'b0;
      dma_q         <= 1'b0;
      trigger_q     <= '0;
    end else if (awake && (rbr_we || ier_we || iir_we || baud_loaded_q)) begin
      baud_loaded_q <= (rbr_we || ier_we) && dlab;
      if (rbr_we && dlab) begin
        divisor_q[7:0] <= wdata;
        baud_on_q      <= {divisor_q[15:8], wdata} != '0;
      end
      if (ier_we && dlab) begin
        divisor_q[15:8] <= wdata;
        baud_on_q       <= {wdata, divisor_q[7:0]} != '0;
      end
      if (iir_we) begin
        fifo_on_q <= wdata[0];
        if (wdata[0]) {trigger_q, dma_q} <= {wdata[7:6], wdata[3]};
      end
    end
  end

  logic pins_change, pins_changed_q;
  assign pins_change = {rxd_i, modem_i} != pins_q;
  assign awake_o     = awake || pins_change;
  assign awake       = access_i || activity_q;
  assign activity    = awake ? access_i || pins_changed_q || tx_busy || tx_level != '0 || !rx_idle ||
                         rx_fresh || timing || changed_q || baud_loaded_q || modem_filling : 1'b0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      activity_q     <= 1'b1;
      pins_changed_q <= 1'b0;
      pins_q         <= '0;
    end else begin
      activity_q     <= activity || pins_change;
      pins_changed_q <= pins_change;
      pins_q         <= {rxd_i, modem_i};
    end
  end

  // At most one strobe is 1 at a time. While the bus is idle the simulator evaluates only the strobes.
  logic [7:0] lsr;
  assign lsr   = !lsr_re ? 8'd0 : {fifo_error, tx_level == '0 && !tx_busy, tx_level == '0, line_errors, rx_waiting};
  assign rdata = rbr_re ? (dlab ? divisor_q[7:0] : rx_waiting ? rx_top : 8'd0) :
                 ier_re ? (dlab ? divisor_q[15:8] : {4'd0, ier}) :
                 iir_re ? (dlab ? {trigger_q, 2'd0, dma_q, 2'd0, fifo_on_q} : {{2{fifo_on_q}}, 2'd0, source}) :
                 lsr_re ? lsr :
                 msr_re ? msr : 8'd0;

  `ASSERT(SleepsOnlyAtRest, awake || (!tx_busy && tx_level == '0 && rx_idle && !rx_fresh && !baud_loaded_q))

  `COVER(WokenByTheLine, !awake && pins_change)
  `COVER(WokenByTheBus, awake && !activity_q && access_i)

endmodule
