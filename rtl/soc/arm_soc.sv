// Programmable logic of the six-axis controller: one AXI4-Lite port and the pins of six axes. Wiring only.
//
// In buses with one bit per axis, axis 1 is bit 0. Every output is a flop. The block that uses an asynchronous input
// synchronises it, so no combinational path starts at a pin.
`include "axi_lite_types.svh"

module arm_soc #(
  // 0: counts per tick, one decoder per axis. 1: the logic of Vo 2021, section 4, to measure its limits: half periods
  // instead of counts, and one decoder behind a switch.
  parameter bit PaperFabric = 1'b0
) (
  input  logic        clk_i,   // soc_map_pkg::ClkFreqHz
  input  logic        rst_ni,  // synchronous

  // Clocks of the blocks that are idle most of the time. Each is clk_i, or clk_i gated by its bit of active_o: while
  // rst_ni is 1, the edges before which the bit is 0 may be left out, because they change no flop (proved in
  // tests/formal). A clock buffer with an enable saves power this way, and a simulator saves time. active_o is the only
  // combinational output. It depends on flops only, so clk_bus_i also needs the edges at which an s_axi_*valid_i is 1.
  input  logic        clk_io_i,       // bit 0: axi_gpio and axi_uart16550
  input  logic        clk_motion_i,   // bit 1: registers of axi_timer, and pulse_train without its pulse generators
  input  logic        clk_encoder_i,  // bit 2: encoder
  input  logic        clk_bus_i,      // bit 3: crossbar
  input  logic        clk_ik_i,       // bit 4: ik_cordic; no use in the paper's variant
  input  logic        clk_policy_i,   // bit 5: policy_mlp; no use in the paper's variant
  output logic [5:0]  active_o,       // clock requests

  // AXI4-Lite slave; addresses: rtl/REGISTERS.md
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

  // Pins, from the table in soc_map.toml. trigger_o is GenerateOut of timer 0. The same flop is the trigger of the
  // blocks, without delay.
`include "arm_soc_pins.svh"
);

  // Master ports of the crossbar.
  localparam int AxiGpio       = soc_map_pkg::AxiGpioPort;
  localparam int AxiTimer      = soc_map_pkg::AxiTimerPort;
  localparam int AxiUart16550  = soc_map_pkg::AxiUart16550Port;
  localparam int Encoder       = soc_map_pkg::EncoderPort;
  localparam int IkCordic      = soc_map_pkg::IkCordicPort;
  localparam int PolicyMlp     = soc_map_pkg::PolicyMlpPort;
  localparam int EncoderSwitch = soc_map_pkg::EncoderSwitchPort;
  localparam int Pulses        = PaperFabric ? soc_map_pkg::PulseWidthPort : soc_map_pkg::PulseTrainPort;
  localparam int NumBlocks     = PaperFabric ? soc_map_pkg::NumPaperBlocks : soc_map_pkg::NumBlocks;

  localparam logic [soc_map_pkg::MaxBlocks*32-1:0] Base =
      PaperFabric ? soc_map_pkg::PaperXbarBase : soc_map_pkg::XbarBase;
  localparam logic [soc_map_pkg::MaxBlocks*32-1:0] Mask =
      PaperFabric ? soc_map_pkg::PaperXbarMask : soc_map_pkg::XbarMask;

  /* verilator tracing_off */  // every block traces its own part
  logic [NumBlocks*AxiLiteReqBits-1:0] req;
  logic [NumBlocks*AxiLiteRspBits-1:0] rsp;
  /* verilator tracing_on */

  logic bus_active;

  axi_lite_xbar #(
    .NumSlaves(NumBlocks),
    .Base(Base[NumBlocks*32-1:0]),
    .Mask(Mask[NumBlocks*32-1:0])
  ) u_xbar (
    .clk_i          (clk_bus_i),
    .rst_ni,
    .active_o       (bus_active),
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
    .m_axi_o(req),
    .m_axi_i(rsp)
  );

  logic gpio_active, uart_active, timer_active, pulses_active, encoder_active, switch_active, ik_active, policy_active;
  assign active_o = {
    policy_active, ik_active, bus_active, encoder_active, timer_active || pulses_active || switch_active,
    gpio_active || uart_active
  };

  // Channel 1 drives the tool through pads without a tri-state buffer: a released output is low, and DATA reads
  // gpio1_i. Channel 2 has inputs only.
  logic [15:0] gpio1_o, gpio1_t, gpio2_o, gpio2_t;

  axi_gpio #(
    .DoutDefault(axi_gpio_reg_pkg::DataValueReset), .TriDefault(axi_gpio_reg_pkg::TriValueReset), .AllInputs2(1'b1)
  ) u_axi_gpio (
    .clk_i,
    .rst_ni,
    .clk_gated_i    (clk_io_i),
    .active_o       (gpio_active),
    .s_axi_i        (req[AxiGpio*AxiLiteReqBits +: AxiLiteReqBits]),
    .s_axi_o        (rsp[AxiGpio*AxiLiteRspBits +: AxiLiteRspBits]),
    .gpio_i         (gpio1_i),
    .gpio_o         (gpio1_o),
    .gpio_t_o       (gpio1_t),
    .gpio_driven_o  (gpio_o),
    .gpio2_i        (gpio_i),
    .gpio2_o        (gpio2_o),
    .gpio2_t_o      (gpio2_t),
    .irq_o          (irq_o[soc_map_pkg::AxiGpioIrq])
  );

  logic timer1_generate;  // GenerateOut of timer 1 has no pin

  axi_timer u_axi_timer (
    .clk_i,
    .rst_ni,
    .clk_gated_i    (clk_motion_i),
    .active_o       (timer_active),
    .s_axi_i        (req[AxiTimer*AxiLiteReqBits +: AxiLiteReqBits]),
    .s_axi_o        (rsp[AxiTimer*AxiLiteRspBits +: AxiLiteRspBits]),
    .capture_trig_i ({2{capture_trig_i}}),
    .freeze_i       (1'b0),
    .generate_o     ({timer1_generate, trigger_o}),
    .pwm_o,
    .irq_o          (irq_o[soc_map_pkg::AxiTimerIrq])
  );

  logic [1:0] user_outputs;  // OUT1, OUT2 have no pins

  axi_uart16550 u_axi_uart16550 (
    .clk_i,
    .rst_ni,
    .clk_gated_i    (clk_io_i),
    .active_o       (uart_active),
    .s_axi_i        (req[AxiUart16550*AxiLiteReqBits +: AxiLiteReqBits]),
    .s_axi_o        (rsp[AxiUart16550*AxiLiteRspBits +: AxiLiteRspBits]),
    .rxd_i          (uart_rxd_i),
    .txd_o          (uart_txd_o),
    .cts_ni         (uart_cts_ni),
    .dsr_ni         (uart_dsr_ni),
    .dcd_ni         (uart_dcd_ni),
    .ri_ni          (uart_ri_ni),
    .rts_no         (uart_rts_no),
    .dtr_no         (uart_dtr_no),
    .out1_no        (user_outputs[0]),
    .out2_no        (user_outputs[1]),
    .irq_o          (irq_o[soc_map_pkg::AxiUart16550Irq])
  );

  if (PaperFabric) begin : g_paper
    pulse_width u_pulse_width (
      .clk_i,
      .rst_ni,
      .clk_gated_i    (clk_motion_i),
      .active_o       (pulses_active),
      .s_axi_i        (req[Pulses*AxiLiteReqBits +: AxiLiteReqBits]),
      .s_axi_o        (rsp[Pulses*AxiLiteRspBits +: AxiLiteRspBits]),
      .trigger_i      (trigger_o),
      .estop_ni, .home_i, .limit_pos_i, .limit_neg_i, .drive_alarm_i, .in_position_i,
      .step_o, .dir_o, .servo_on_o, .heartbeat_o
    );

    logic unused_clocks;
    assign unused_clocks = ^{clk_ik_i, clk_policy_i};
    assign ik_active     = 1'b0;
    assign policy_active = 1'b0;
    assign irq_o[soc_map_pkg::IkCordicIrq]  = 1'b0;
    assign irq_o[soc_map_pkg::PolicyMlpIrq] = 1'b0;

    logic selected_a, selected_b, selected_z;

    encoder_switch u_encoder_switch (
      .clk_i,
      .rst_ni,
      .clk_gated_i    (clk_motion_i),
      .active_o       (switch_active),
      .s_axi_i        (req[EncoderSwitch*AxiLiteReqBits +: AxiLiteReqBits]),
      .s_axi_o        (rsp[EncoderSwitch*AxiLiteRspBits +: AxiLiteRspBits]),
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
      .clk_gated_i    (clk_encoder_i),
      .active_o       (encoder_active),
      .s_axi_i        (req[Encoder*AxiLiteReqBits +: AxiLiteReqBits]),
      .s_axi_o        (rsp[Encoder*AxiLiteRspBits +: AxiLiteRspBits]),
      .trigger_i      (trigger_o),
      .servo_on_i     (servo_on_o),
      .enc_a_i        (selected_a),
      .enc_b_i        (selected_b),
      .enc_z_i        (selected_z)
    );
  end else begin : g_rtl
    assign switch_active = 1'b0;

    pulse_train u_pulse_train (
      .clk_i,
      .rst_ni,
      .clk_gated_i    (clk_motion_i),
      .active_o       (pulses_active),
      .s_axi_i        (req[Pulses*AxiLiteReqBits +: AxiLiteReqBits]),
      .s_axi_o        (rsp[Pulses*AxiLiteRspBits +: AxiLiteRspBits]),
      .trigger_i      (trigger_o),
      .estop_ni, .home_i, .limit_pos_i, .limit_neg_i, .drive_alarm_i, .in_position_i,
      .step_o, .dir_o, .servo_on_o, .heartbeat_o
    );

    encoder u_encoder (
      .clk_i,
      .rst_ni,
      .clk_gated_i    (clk_encoder_i),
      .active_o       (encoder_active),
      .s_axi_i        (req[Encoder*AxiLiteReqBits +: AxiLiteReqBits]),
      .s_axi_o        (rsp[Encoder*AxiLiteRspBits +: AxiLiteRspBits]),
      .trigger_i      (trigger_o),
      .servo_on_i     (servo_on_o),
      .enc_a_i,
      .enc_b_i,
      .enc_z_i
    );

    ik_cordic u_ik_cordic (
      .clk_i          (clk_ik_i),
      .rst_ni,
      .active_o       (ik_active),
      .s_axi_i        (req[IkCordic*AxiLiteReqBits +: AxiLiteReqBits]),
      .s_axi_o        (rsp[IkCordic*AxiLiteRspBits +: AxiLiteRspBits]),
      .irq_o          (irq_o[soc_map_pkg::IkCordicIrq])
    );

    policy_mlp u_policy_mlp (
      .clk_i          (clk_policy_i),
      .rst_ni,
      .active_o       (policy_active),
      .s_axi_i        (req[PolicyMlp*AxiLiteReqBits +: AxiLiteReqBits]),
      .s_axi_o        (rsp[PolicyMlp*AxiLiteRspBits +: AxiLiteRspBits]),
      .irq_o          (irq_o[soc_map_pkg::PolicyMlpIrq])
    );
  end

  logic unused;
  assign unused = ^{gpio1_o, gpio1_t, gpio2_o, gpio2_t, timer1_generate, user_outputs};

endmodule
