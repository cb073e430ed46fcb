// AXI Timer v2.0 compatible block: two 32-bit timers, or one of 64 bits, or a PWM output; one interrupt line.
//
// The end of a period sets the flag of its timer and its generate_o in the same clock; irq_o follows one clock later.
module axi_timer #(
  parameter bit Gen0Assert  = 1'b1,  // active levels: GenerateOut of timer 0 and 1, capture pins of timer 0 and 1
  parameter bit Gen1Assert  = 1'b1,
  parameter bit Trig0Assert = 1'b1,
  parameter bit Trig1Assert = 1'b1
) (
  input  logic        clk_i,
  input  logic        rst_ni,  // synchronous

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

  input  logic [1:0]  capture_trig_i,  // asynchronous; bit i: timer i. An edge stores the TCR of three clocks later
  input  logic        freeze_i,        // asynchronous; both counters stand still from two clocks later on
  output logic [1:0]  generate_o,      // bit i: active for one clock per period of timer i, from a flop
  output logic        pwm_o,           // from a flop
  output logic        irq_o            // level until acknowledged, from a flop
);

  logic        reg_we, reg_werr, reg_re, reg_rerr;
  logic [15:0] reg_waddr, reg_raddr;
  logic [31:0] reg_wdata, reg_rdata;
  logic [3:0]  reg_wstrb;

  axi_lite_slave #(.AddrWidth(16)) u_bus (
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

  logic        tcsr0_we, tlr0_we, tcsr1_we, tlr1_we;
  logic [31:0] tcsr0, tlr0, tcr0, tcsr1, tlr1, tcr1;

  // Data and byte strobes of every external register are those of the strobe bus, and no read has a side effect.
  axi_timer_reg_top u_regs (
    .clk_i,
    .rst_ni,
    .reg_we_i     (reg_we),
    .reg_waddr_i  (reg_waddr),
    .reg_wdata_i  (reg_wdata),
    .reg_wstrb_i  (reg_wstrb),
    .reg_werr_o   (reg_werr),
    .reg_re_i     (reg_re),
    .reg_raddr_i  (reg_raddr),
    .reg_rdata_o  (reg_rdata),
    .reg_rerr_o   (reg_rerr),
    .tcsr0_we_o   (tcsr0_we),
    .tcsr0_wdata_o(),
    .tcsr0_wstrb_o(),
    .tcsr0_re_o   (),
    .tcsr0_rdata_i(tcsr0),
    .tlr0_we_o    (tlr0_we),
    .tlr0_wdata_o (),
    .tlr0_wstrb_o (),
    .tlr0_re_o    (),
    .tlr0_rdata_i (tlr0),
    .tcr0_re_o    (),
    .tcr0_rdata_i (tcr0),
    .tcsr1_we_o   (tcsr1_we),
    .tcsr1_wdata_o(),
    .tcsr1_wstrb_o(),
    .tcsr1_re_o   (),
    .tcsr1_rdata_i(tcsr1),
    .tlr1_we_o    (tlr1_we),
    .tlr1_wdata_o (),
    .tlr1_wstrb_o (),
    .tlr1_re_o    (),
    .tlr1_rdata_i (tlr1),
    .tcr1_re_o    (),
    .tcr1_rdata_i (tcr1)
  );

  timer_core #(
    .Gen0Assert (Gen0Assert),
    .Gen1Assert (Gen1Assert),
    .Trig0Assert(Trig0Assert),
    .Trig1Assert(Trig1Assert)
  ) u_core (
    .clk_i,
    .rst_ni,
    .tcsr0_we_i(tcsr0_we),
    .tlr0_we_i (tlr0_we),
    .tcsr1_we_i(tcsr1_we),
    .tlr1_we_i (tlr1_we),
    .wdata_i   (reg_wdata),
    .wstrb_i   (reg_wstrb),
    .tcsr0_o   (tcsr0),
    .tlr0_o    (tlr0),
    .tcr0_o    (tcr0),
    .tcsr1_o   (tcsr1),
    .tlr1_o    (tlr1),
    .tcr1_o    (tcr1),
    .capture_trig_i,
    .freeze_i,
    .generate_o,
    .pwm_o,
    .irq_o
  );

endmodule
