// AXI UART 16550 v2.0 compatible block: byte registers in words from 0x1000 on, one interrupt line.
//
// Words below 0x1000 read 0 and ignore writes, as in the vendor's core; words from 0x1020 on are errors. A write without
// byte 0 changes nothing, so byte and word accesses work alike. irq_o is a level, one clock behind the registers.
module axi_uart16550 (
  input  logic        clk_i,
  input  logic        rst_ni,  // synchronous

  // Clock of all but the synchronisers: clk_i, or clk_i without the edges before which active_o is low while rst_ni is
  // high; nothing would change at them. For a clock buffer with enable, and for simulators, whose idle clocks cost time.
  input  logic        clk_gated_i,
  output logic        active_o,

  input  logic [15:0] s_axi_awaddr_i,
  input  logic        s_axi_awvalid_i,
  output logic        s_axi_awready_o,
  input  logic [31:0] s_axi_wdata_i,
  input  logic [3:0]  s_axi_wstrb_i,
  input  logic        s_axi_wvalid_i,
  output logic        s_axi_wready_o,
  output logic [1:0]  s_axi_bresp_o,
  output logic        s_axi_bvalid_o,
  input  logic        s_axi_bready_i,
  input  logic [15:0] s_axi_araddr_i,
  input  logic        s_axi_arvalid_i,
  output logic        s_axi_arready_o,
  output logic [31:0] s_axi_rdata_o,
  output logic [1:0]  s_axi_rresp_o,
  output logic        s_axi_rvalid_o,
  input  logic        s_axi_rready_i,

  // Every input goes through a synchroniser, every output comes from a flop. Tie an unused rxd_i and modem line high.
  input  logic        rxd_i,
  output logic        txd_o,    // idles high
  input  logic        cts_ni,
  input  logic        dsr_ni,
  input  logic        dcd_ni,
  input  logic        ri_ni,
  output logic        rts_no,
  output logic        dtr_no,
  output logic        out1_no,
  output logic        out2_no,
  output logic        irq_o
);

  logic        reg_we, reg_werr, reg_re, reg_rerr;
  logic [15:0] reg_waddr, reg_raddr;
  logic [31:0] reg_wdata, reg_rdata;
  logic [3:0]  reg_wstrb;

  // At rest nothing but the synchroniser moves.
  logic core_awake, bus_rests;
  assign bus_rests = s_axi_awready_o && s_axi_wready_o && s_axi_arready_o &&
                     !s_axi_awvalid_i && !s_axi_wvalid_i && !s_axi_arvalid_i;
  assign active_o  = !bus_rests || core_awake;

  logic       rxd;
  logic [3:0] modem_lines;
  sync_2ff #(.Width(5)) u_sync (
    .clk_i,
    .rst_ni,
    .async_i({rxd_i, ~{dcd_ni, ri_ni, dsr_ni, cts_ni}}),
    .level_o({rxd, modem_lines})
  );

  axi_lite_slave #(.AddrWidth(16)) u_bus (
    .clk_i(clk_gated_i),
    .rst_ni,
    .s_axi_awaddr_i,
    .s_axi_awvalid_i,
    .s_axi_awready_o,
    .s_axi_wdata_i,
    .s_axi_wstrb_i,
    .s_axi_wvalid_i,
    .s_axi_wready_o,
    .s_axi_bresp_o,
    .s_axi_bvalid_o,
    .s_axi_bready_i,
    .s_axi_araddr_i,
    .s_axi_arvalid_i,
    .s_axi_arready_o,
    .s_axi_rdata_o,
    .s_axi_rresp_o,
    .s_axi_rvalid_o,
    .s_axi_rready_i,
    .reg_we_o   (reg_we),
    .reg_waddr_o(reg_waddr),
    .reg_wdata_o(reg_wdata),
    .reg_wstrb_o(reg_wstrb),
    .reg_werr_i (reg_werr),
    .reg_re_o   (reg_re),
    .reg_raddr_o(reg_raddr),
    .reg_rdata_i(reg_rdata),
    .reg_rerr_i (reg_rerr)
  );

  logic       rbr_we, rbr_re, ier_we, ier_re, iir_we, iir_re, lsr_re, msr_re;
  logic [7:0] lcr, rdata;
  logic [4:0] mcr;

  // Data and byte strobes of every external register are those of the strobe bus; all words below 0x1000 are one.
  axi_uart16550_reg_top u_regs (
    .clk_i(clk_gated_i),
    .rst_ni,
    .reg_we_i        (reg_we),
    .reg_waddr_i     (reg_waddr[15:12] == '0 ? 16'd0 : reg_waddr),
    .reg_wdata_i     (reg_wdata),
    .reg_wstrb_i     (reg_wstrb),
    .reg_werr_o      (reg_werr),
    .reg_re_i        (reg_re),
    .reg_raddr_i     (reg_raddr[15:12] == '0 ? 16'd0 : reg_raddr),
    .reg_rdata_o     (reg_rdata),
    .reg_rerr_o      (reg_rerr),
    .reserved_we_o   (),
    .reserved_wdata_o(),
    .reserved_wstrb_o(),
    .reserved_re_o   (),
    .reserved_rdata_i(32'd0),
    .rbr_we_o        (rbr_we),
    .rbr_wdata_o     (),
    .rbr_wstrb_o     (),
    .rbr_re_o        (rbr_re),
    .rbr_rdata_i     ({24'd0, rdata}),
    .ier_we_o        (ier_we),
    .ier_wdata_o     (),
    .ier_wstrb_o     (),
    .ier_re_o        (ier_re),
    .ier_rdata_i     ({24'd0, rdata}),
    .iir_we_o        (iir_we),
    .iir_wdata_o     (),
    .iir_wstrb_o     (),
    .iir_re_o        (iir_re),
    .iir_rdata_i     ({24'd0, rdata}),
    .lcr_length_o    (lcr[1:0]),
    .lcr_stop_o      (lcr[2]),
    .lcr_parity_o    (lcr[3]),
    .lcr_even_o      (lcr[4]),
    .lcr_stick_o     (lcr[5]),
    .lcr_brk_o       (lcr[6]),
    .lcr_dlab_o      (lcr[7]),
    .mcr_dtr_o       (mcr[0]),
    .mcr_rts_o       (mcr[1]),
    .mcr_out1_o      (mcr[2]),
    .mcr_out2_o      (mcr[3]),
    .mcr_loop_o      (mcr[4]),
    .lsr_re_o        (lsr_re),
    .lsr_rdata_i     ({24'd0, rdata}),
    .msr_re_o        (msr_re),
    .msr_rdata_i     ({24'd0, rdata}),
    .scr_value_o     ()
  );

  uart_core u_core (
    .clk_i(clk_gated_i),
    .rst_ni,
    .access_i(reg_we || reg_re),
    .rbr_we_i(rbr_we && reg_wstrb[0]),
    .rbr_re_i(rbr_re),
    .ier_we_i(ier_we && reg_wstrb[0]),
    .ier_re_i(ier_re),
    .iir_we_i(iir_we && reg_wstrb[0]),
    .iir_re_i(iir_re),
    .lsr_re_i(lsr_re),
    .msr_re_i(msr_re),
    .wdata_i (reg_wdata[7:0]),
    .rdata_o (rdata),
    .lcr_i   (lcr),
    .mcr_i   (mcr),
    .rxd_i   (rxd),
    .modem_i (modem_lines),
    .txd_o,
    .rts_no,
    .dtr_no,
    .out1_no,
    .out2_no,
    .irq_o,
    .awake_o (core_awake)
  );

endmodule
