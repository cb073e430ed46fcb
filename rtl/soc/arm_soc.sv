// Programmable logic of the six-axis controller: one AXI4-Lite port and the pins of six axes. Wiring only.
//
// Buses with one bit per axis: axis 1 is bit 0. Every output is a flop, and every asynchronous input is synchronised in
// the block that uses it, so no combinational path starts at a pin.
module arm_soc #(
  // 0: counts per tick and a decoder per axis. 1: the logic as Vo 2021 section 4 describes it, to measure its limits:
  // half periods instead of counts, and one decoder behind a switch.
  parameter bit PaperFabric = 1'b0
) (
  input  logic        clk_i,   // soc_map_pkg::ClkFreqHz
  input  logic        rst_ni,  // synchronous

  // Clock of axi_gpio and axi_uart16550, which mostly rest: clk_i, or clk_i without the edges before which io_active_o is
  // low while rst_ni is high. io_active_o is made of flops, the only output that is none.
  input  logic        clk_io_i,
  output logic        io_active_o,

  // AXI4-Lite slave, addresses as in rtl/REGISTERS.md
  input  logic [31:0] s_axi_awaddr_i,
  input  logic        s_axi_awvalid_i,
  output logic        s_axi_awready_o,
  input  logic [31:0] s_axi_wdata_i,
  input  logic [3:0]  s_axi_wstrb_i,
  input  logic        s_axi_wvalid_i,
  output logic        s_axi_wready_o,
  output logic [1:0]  s_axi_bresp_o,
  output logic        s_axi_bvalid_o,
  input  logic        s_axi_bready_i,
  input  logic [31:0] s_axi_araddr_i,
  input  logic        s_axi_arvalid_i,
  output logic        s_axi_arready_o,
  output logic [31:0] s_axi_rdata_o,
  output logic [1:0]  s_axi_rresp_o,
  output logic        s_axi_rvalid_o,
  input  logic        s_axi_rready_i,

  // Pins, from the table in soc_map.toml. trigger_o is GenerateOut of timer 0: the very flop that the blocks see as
  // their trigger, no clock later.
`include "arm_soc_pins.svh"
);

  // Master ports of the crossbar.
  localparam int AxiGpio       = soc_map_pkg::AxiGpioPort;
  localparam int AxiTimer      = soc_map_pkg::AxiTimerPort;
  localparam int AxiUart16550  = soc_map_pkg::AxiUart16550Port;
  localparam int Encoder       = soc_map_pkg::EncoderPort;
  localparam int EncoderSwitch = soc_map_pkg::EncoderSwitchPort;
  localparam int Pulses        = PaperFabric ? soc_map_pkg::PulseWidthPort : soc_map_pkg::PulseTrainPort;
  localparam int NumBlocks     = PaperFabric ? soc_map_pkg::NumPaperBlocks : soc_map_pkg::NumBlocks;

  localparam logic [soc_map_pkg::MaxBlocks*32-1:0] Base =
      PaperFabric ? soc_map_pkg::PaperXbarBase : soc_map_pkg::XbarBase;
  localparam logic [soc_map_pkg::MaxBlocks*32-1:0] Mask =
      PaperFabric ? soc_map_pkg::PaperXbarMask : soc_map_pkg::XbarMask;

  logic [15:0]             awaddr, araddr;
  logic [31:0]             wdata;
  logic [3:0]              wstrb;
  logic [NumBlocks-1:0]    awvalid, awready, wvalid, wready, bvalid, bready;
  logic [NumBlocks-1:0]    arvalid, arready, rvalid, rready;
  logic [NumBlocks*2-1:0]  bresp, rresp;
  logic [NumBlocks*32-1:0] rdata;

  axi_lite_xbar #(
    .NumSlaves(NumBlocks),
    .SlaveAddrWidth(16),
    .Base(Base[NumBlocks*32-1:0]),
    .Mask(Mask[NumBlocks*32-1:0])
  ) u_xbar (
    .clk_i,
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
    .m_axi_awaddr_o (awaddr),
    .m_axi_awvalid_o(awvalid),
    .m_axi_awready_i(awready),
    .m_axi_wdata_o  (wdata),
    .m_axi_wstrb_o  (wstrb),
    .m_axi_wvalid_o (wvalid),
    .m_axi_wready_i (wready),
    .m_axi_bresp_i  (bresp),
    .m_axi_bvalid_i (bvalid),
    .m_axi_bready_o (bready),
    .m_axi_araddr_o (araddr),
    .m_axi_arvalid_o(arvalid),
    .m_axi_arready_i(arready),
    .m_axi_rdata_i  (rdata),
    .m_axi_rresp_i  (rresp),
    .m_axi_rvalid_i (rvalid),
    .m_axi_rready_o (rready)
  );

  logic gpio_active, uart_active;
  assign io_active_o = gpio_active || uart_active;

  axi_gpio u_axi_gpio (
    .clk_i,
    .rst_ni,
    .clk_gated_i    (clk_io_i),
    .active_o       (gpio_active),
    .s_axi_awaddr_i (awaddr),
    .s_axi_awvalid_i(awvalid[AxiGpio]),
    .s_axi_awready_o(awready[AxiGpio]),
    .s_axi_wdata_i  (wdata),
    .s_axi_wstrb_i  (wstrb),
    .s_axi_wvalid_i (wvalid[AxiGpio]),
    .s_axi_wready_o (wready[AxiGpio]),
    .s_axi_bresp_o  (bresp[AxiGpio*2+:2]),
    .s_axi_bvalid_o (bvalid[AxiGpio]),
    .s_axi_bready_i (bready[AxiGpio]),
    .s_axi_araddr_i (araddr),
    .s_axi_arvalid_i(arvalid[AxiGpio]),
    .s_axi_arready_o(arready[AxiGpio]),
    .s_axi_rdata_o  (rdata[AxiGpio*32+:32]),
    .s_axi_rresp_o  (rresp[AxiGpio*2+:2]),
    .s_axi_rvalid_o (rvalid[AxiGpio]),
    .s_axi_rready_i (rready[AxiGpio]),
    .gpio_i,
    .gpio_o,
    .irq_o          (irq_o[soc_map_pkg::AxiGpioIrq])
  );

  logic timer1_generate;  // GenerateOut of timer 1 has no pin

  axi_timer u_axi_timer (
    .clk_i,
    .rst_ni,
    .s_axi_awaddr_i (awaddr),
    .s_axi_awvalid_i(awvalid[AxiTimer]),
    .s_axi_awready_o(awready[AxiTimer]),
    .s_axi_wdata_i  (wdata),
    .s_axi_wstrb_i  (wstrb),
    .s_axi_wvalid_i (wvalid[AxiTimer]),
    .s_axi_wready_o (wready[AxiTimer]),
    .s_axi_bresp_o  (bresp[AxiTimer*2+:2]),
    .s_axi_bvalid_o (bvalid[AxiTimer]),
    .s_axi_bready_i (bready[AxiTimer]),
    .s_axi_araddr_i (araddr),
    .s_axi_arvalid_i(arvalid[AxiTimer]),
    .s_axi_arready_o(arready[AxiTimer]),
    .s_axi_rdata_o  (rdata[AxiTimer*32+:32]),
    .s_axi_rresp_o  (rresp[AxiTimer*2+:2]),
    .s_axi_rvalid_o (rvalid[AxiTimer]),
    .s_axi_rready_i (rready[AxiTimer]),
    .capture_trig_i ({2{capture_trig_i}}),
    .freeze_i       (1'b0),
    .generate_o     ({timer1_generate, trigger_o}),
    .pwm_o,
    .irq_o          (irq_o[soc_map_pkg::AxiTimerIrq])
  );

  logic [3:0] modem;  // RTS, DTR, OUT1, OUT2 have no pins

  axi_uart16550 u_axi_uart16550 (
    .clk_i,
    .rst_ni,
    .clk_gated_i    (clk_io_i),
    .active_o       (uart_active),
    .s_axi_awaddr_i (awaddr),
    .s_axi_awvalid_i(awvalid[AxiUart16550]),
    .s_axi_awready_o(awready[AxiUart16550]),
    .s_axi_wdata_i  (wdata),
    .s_axi_wstrb_i  (wstrb),
    .s_axi_wvalid_i (wvalid[AxiUart16550]),
    .s_axi_wready_o (wready[AxiUart16550]),
    .s_axi_bresp_o  (bresp[AxiUart16550*2+:2]),
    .s_axi_bvalid_o (bvalid[AxiUart16550]),
    .s_axi_bready_i (bready[AxiUart16550]),
    .s_axi_araddr_i (araddr),
    .s_axi_arvalid_i(arvalid[AxiUart16550]),
    .s_axi_arready_o(arready[AxiUart16550]),
    .s_axi_rdata_o  (rdata[AxiUart16550*32+:32]),
    .s_axi_rresp_o  (rresp[AxiUart16550*2+:2]),
    .s_axi_rvalid_o (rvalid[AxiUart16550]),
    .s_axi_rready_i (rready[AxiUart16550]),
    .rxd_i          (uart_rxd_i),
    .txd_o          (uart_txd_o),
    .cts_ni         (1'b1),
    .dsr_ni         (1'b1),
    .dcd_ni         (1'b1),
    .ri_ni          (1'b1),
    .rts_no         (modem[0]),
    .dtr_no         (modem[1]),
    .out1_no        (modem[2]),
    .out2_no        (modem[3]),
    .irq_o          (irq_o[soc_map_pkg::AxiUart16550Irq])
  );

  if (PaperFabric) begin : g_paper
    pulse_width u_pulse_width (
      .clk_i,
      .rst_ni,
      .s_axi_awaddr_i (awaddr),
      .s_axi_awvalid_i(awvalid[Pulses]),
      .s_axi_awready_o(awready[Pulses]),
      .s_axi_wdata_i  (wdata),
      .s_axi_wstrb_i  (wstrb),
      .s_axi_wvalid_i (wvalid[Pulses]),
      .s_axi_wready_o (wready[Pulses]),
      .s_axi_bresp_o  (bresp[Pulses*2+:2]),
      .s_axi_bvalid_o (bvalid[Pulses]),
      .s_axi_bready_i (bready[Pulses]),
      .s_axi_araddr_i (araddr),
      .s_axi_arvalid_i(arvalid[Pulses]),
      .s_axi_arready_o(arready[Pulses]),
      .s_axi_rdata_o  (rdata[Pulses*32+:32]),
      .s_axi_rresp_o  (rresp[Pulses*2+:2]),
      .s_axi_rvalid_o (rvalid[Pulses]),
      .s_axi_rready_i (rready[Pulses]),
      .trigger_i      (trigger_o),
      .estop_ni,
      .home_i,
      .limit_pos_i,
      .limit_neg_i,
      .drive_alarm_i,
      .in_position_i,
      .step_o,
      .dir_o,
      .servo_on_o
    );

    logic selected_a, selected_b, selected_z;

    encoder_switch u_encoder_switch (
      .clk_i,
      .rst_ni,
      .s_axi_awaddr_i (awaddr),
      .s_axi_awvalid_i(awvalid[EncoderSwitch]),
      .s_axi_awready_o(awready[EncoderSwitch]),
      .s_axi_wdata_i  (wdata),
      .s_axi_wstrb_i  (wstrb),
      .s_axi_wvalid_i (wvalid[EncoderSwitch]),
      .s_axi_wready_o (wready[EncoderSwitch]),
      .s_axi_bresp_o  (bresp[EncoderSwitch*2+:2]),
      .s_axi_bvalid_o (bvalid[EncoderSwitch]),
      .s_axi_bready_i (bready[EncoderSwitch]),
      .s_axi_araddr_i (araddr),
      .s_axi_arvalid_i(arvalid[EncoderSwitch]),
      .s_axi_arready_o(arready[EncoderSwitch]),
      .s_axi_rdata_o  (rdata[EncoderSwitch*32+:32]),
      .s_axi_rresp_o  (rresp[EncoderSwitch*2+:2]),
      .s_axi_rvalid_o (rvalid[EncoderSwitch]),
      .s_axi_rready_i (rready[EncoderSwitch]),
      .enc_a_i,
      .enc_b_i,
      .enc_z_i,
      .enc_a_o        (selected_a),
      .enc_b_o        (selected_b),
      .enc_z_o        (selected_z)
    );

    encoder #(.Axes(1)) u_encoder (
      .clk_i,
      .rst_ni,
      .s_axi_awaddr_i (awaddr),
      .s_axi_awvalid_i(awvalid[Encoder]),
      .s_axi_awready_o(awready[Encoder]),
      .s_axi_wdata_i  (wdata),
      .s_axi_wstrb_i  (wstrb),
      .s_axi_wvalid_i (wvalid[Encoder]),
      .s_axi_wready_o (wready[Encoder]),
      .s_axi_bresp_o  (bresp[Encoder*2+:2]),
      .s_axi_bvalid_o (bvalid[Encoder]),
      .s_axi_bready_i (bready[Encoder]),
      .s_axi_araddr_i (araddr),
      .s_axi_arvalid_i(arvalid[Encoder]),
      .s_axi_arready_o(arready[Encoder]),
      .s_axi_rdata_o  (rdata[Encoder*32+:32]),
      .s_axi_rresp_o  (rresp[Encoder*2+:2]),
      .s_axi_rvalid_o (rvalid[Encoder]),
      .s_axi_rready_i (rready[Encoder]),
      .trigger_i      (trigger_o),
      .enc_a_i        (selected_a),
      .enc_b_i        (selected_b),
      .enc_z_i        (selected_z)
    );
  end else begin : g_rtl
    pulse_train u_pulse_train (
      .clk_i,
      .rst_ni,
      .s_axi_awaddr_i (awaddr),
      .s_axi_awvalid_i(awvalid[Pulses]),
      .s_axi_awready_o(awready[Pulses]),
      .s_axi_wdata_i  (wdata),
      .s_axi_wstrb_i  (wstrb),
      .s_axi_wvalid_i (wvalid[Pulses]),
      .s_axi_wready_o (wready[Pulses]),
      .s_axi_bresp_o  (bresp[Pulses*2+:2]),
      .s_axi_bvalid_o (bvalid[Pulses]),
      .s_axi_bready_i (bready[Pulses]),
      .s_axi_araddr_i (araddr),
      .s_axi_arvalid_i(arvalid[Pulses]),
      .s_axi_arready_o(arready[Pulses]),
      .s_axi_rdata_o  (rdata[Pulses*32+:32]),
      .s_axi_rresp_o  (rresp[Pulses*2+:2]),
      .s_axi_rvalid_o (rvalid[Pulses]),
      .s_axi_rready_i (rready[Pulses]),
      .trigger_i      (trigger_o),
      .estop_ni,
      .home_i,
      .limit_pos_i,
      .limit_neg_i,
      .drive_alarm_i,
      .in_position_i,
      .step_o,
      .dir_o,
      .servo_on_o
    );

    encoder u_encoder (
      .clk_i,
      .rst_ni,
      .s_axi_awaddr_i (awaddr),
      .s_axi_awvalid_i(awvalid[Encoder]),
      .s_axi_awready_o(awready[Encoder]),
      .s_axi_wdata_i  (wdata),
      .s_axi_wstrb_i  (wstrb),
      .s_axi_wvalid_i (wvalid[Encoder]),
      .s_axi_wready_o (wready[Encoder]),
      .s_axi_bresp_o  (bresp[Encoder*2+:2]),
      .s_axi_bvalid_o (bvalid[Encoder]),
      .s_axi_bready_i (bready[Encoder]),
      .s_axi_araddr_i (araddr),
      .s_axi_arvalid_i(arvalid[Encoder]),
      .s_axi_arready_o(arready[Encoder]),
      .s_axi_rdata_o  (rdata[Encoder*32+:32]),
      .s_axi_rresp_o  (rresp[Encoder*2+:2]),
      .s_axi_rvalid_o (rvalid[Encoder]),
      .s_axi_rready_i (rready[Encoder]),
      .trigger_i      (trigger_o),
      .enc_a_i,
      .enc_b_i,
      .enc_z_i
    );
  end

  logic unused;
  assign unused = ^{timer1_generate, modem};

endmodule
