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

  // Servo drives
  output logic [5:0]  step_o,
  output logic [5:0]  dir_o,
  output logic [5:0]  servo_on_o,
  input  logic [5:0]  drive_alarm_i,
  input  logic [5:0]  in_position_i,

  // Encoders and switches
  input  logic [5:0]  enc_a_i,
  input  logic [5:0]  enc_b_i,
  input  logic [5:0]  enc_z_i,
  input  logic [5:0]  home_i,
  input  logic [5:0]  limit_pos_i,
  input  logic [5:0]  limit_neg_i,
  input  logic        estop_ni,

  // Serial line of the pendant, idle high
  input  logic        uart_rxd_i,
  output logic        uart_txd_o,

  // End-effector tools: channel 2 of axi_gpio in, channel 1 out
  input  logic [15:0] gpio_i,
  output logic [15:0] gpio_o,

  // axi_timer: capture event of both timers, PWM0
  input  logic        capture_trig_i,
  output logic        pwm_o,

  // GenerateOut of timer 0: the very flop that the blocks see as their trigger, no clock later. The edge that ends the
  // clock in which it is high makes the committed counts active and takes the position snapshots.
  output logic        trigger_o,
  output logic [soc_map_pkg::NumIrqs-1:0] irq_o  // levels, bits as in soc_map_pkg; one clock after the event
);

  // Master ports of the crossbar, in the order of the address map.
  localparam int AxiTimer   = 0;
  localparam int PulseTrain = 1;
  localparam int Encoder    = 2;
  localparam int NumBlocks  = soc_map_pkg::NumBlocks;

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
    .Base({soc_map_pkg::EncoderBase, soc_map_pkg::PulseTrainBase, soc_map_pkg::AxiTimerBase}),
    .Mask({~(soc_map_pkg::EncoderSize - 32'd1), ~(soc_map_pkg::PulseTrainSize - 32'd1),
           ~(soc_map_pkg::AxiTimerSize - 32'd1)})
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

  logic timer1_generate, timer_pwm;  // without a pin

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
    .capture_trig_i (2'b00),
    .freeze_i       (1'b0),
    .generate_o     ({timer1_generate, trigger_o}),
    .pwm_o          (timer_pwm),
    .irq_o          (irq_o[soc_map_pkg::AxiTimerIrq])
  );

  pulse_train u_pulse_train (
    .clk_i,
    .rst_ni,
    .s_axi_awaddr_i (awaddr),
    .s_axi_awvalid_i(awvalid[PulseTrain]),
    .s_axi_awready_o(awready[PulseTrain]),
    .s_axi_wdata_i  (wdata),
    .s_axi_wstrb_i  (wstrb),
    .s_axi_wvalid_i (wvalid[PulseTrain]),
    .s_axi_wready_o (wready[PulseTrain]),
    .s_axi_bresp_o  (bresp[PulseTrain*2+:2]),
    .s_axi_bvalid_o (bvalid[PulseTrain]),
    .s_axi_bready_i (bready[PulseTrain]),
    .s_axi_araddr_i (araddr),
    .s_axi_arvalid_i(arvalid[PulseTrain]),
    .s_axi_arready_o(arready[PulseTrain]),
    .s_axi_rdata_o  (rdata[PulseTrain*32+:32]),
    .s_axi_rresp_o  (rresp[PulseTrain*2+:2]),
    .s_axi_rvalid_o (rvalid[PulseTrain]),
    .s_axi_rready_i (rready[PulseTrain]),
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

  // To be replaced by their blocks.
  always_ff @(posedge clk_i) begin
    uart_txd_o <= 1'b1;
    gpio_o     <= '0;
    pwm_o      <= 1'b0;
  end

  logic unused;
  assign unused = ^{PaperFabric, timer1_generate, timer_pwm, uart_rxd_i, gpio_i, capture_trig_i};

endmodule
