// AXI GPIO v2.0 compatible block, 16 outputs and 16 inputs: bus, register file and core, and the vendor's answers to
// accesses that our own blocks refuse. Registers: axi_gpio_regs.toml.
module axi_gpio (
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

  input  logic [15:0] gpio_i,  // channel 2, asynchronous
  output logic [15:0] gpio_o,  // channel 1, from flops, 0 after reset
  output logic        irq_o    // level, from a flop
);

  logic        reg_we, reg_werr, reg_re, reg_rerr;
  logic [15:0] reg_waddr, bus_raddr, reg_raddr;
  logic [31:0] reg_wdata, reg_rdata;
  logic [3:0]  reg_wstrb;

  // The vendor's map has 512 bytes, without an error anywhere: a word without a register is read as the reserved word,
  // and a write to a word that nothing can be written to is ignored.
  localparam int MapBits = 9;

  logic        reserved;   // the word read has no register
  logic        in_map_write;
  logic [15:0] word;
  assign in_map_write = reg_waddr[15:MapBits] == '0;
  assign word         = {bus_raddr[15:2], 2'b00};
  assign reserved     = word[15:MapBits] == '0 &&
                        word != axi_gpio_reg_pkg::DataOffset && word != axi_gpio_reg_pkg::TriOffset &&
                        word != axi_gpio_reg_pkg::Data2Offset && word != axi_gpio_reg_pkg::Tri2Offset &&
                        word != axi_gpio_reg_pkg::GierOffset && word != axi_gpio_reg_pkg::IsrOffset &&
                        word != axi_gpio_reg_pkg::IerOffset;
  assign reg_raddr    = reserved ? axi_gpio_reg_pkg::ReservedOffset : bus_raddr;

  // At rest nothing but the synchroniser moves.
  logic core_awake, bus_rests;
  assign bus_rests = s_axi_awready_o && s_axi_wready_o && s_axi_arready_o &&
                     !s_axi_awvalid_i && !s_axi_wvalid_i && !s_axi_arvalid_i;
  assign active_o  = !bus_rests || core_awake;

  logic [15:0] data2;
  sync_2ff #(.Width(16)) u_sync (
    .clk_i,
    .rst_ni,
    .async_i(gpio_i),
    .level_o(data2)
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
    .reg_werr_i (reg_werr && !in_map_write),
    .reg_re_o   (reg_re),
    .reg_raddr_o(bus_raddr),
    .reg_rdata_i(reg_rdata),
    .reg_rerr_i (reg_rerr)
  );

  logic [15:0] data, tri_state;
  logic [1:0]  ier, isr, isr_toggle;
  logic        gier, isr_we, isr_re;
  logic [31:0] isr_wdata;
  logic [3:0]  isr_wstrb;
  assign isr_toggle = (isr_we && isr_wstrb[0]) ? isr_wdata[1:0] : 2'b00;

  axi_gpio_reg_top u_regs (
    .clk_i(clk_gated_i),
    .rst_ni,
    .reg_we_i   (reg_we),
    .reg_waddr_i(reg_waddr),
    .reg_wdata_i(reg_wdata),
    .reg_wstrb_i(reg_wstrb),
    .reg_werr_o (reg_werr),
    .reg_re_i   (reg_re),
    .reg_raddr_i(reg_raddr),
    .reg_rdata_o(reg_rdata),
    .reg_rerr_o (reg_rerr),
    .data_value_o  (data),
    .tri_value_o   (tri_state),
    .data2_value_i (data2),
    .gier_enable_o (gier),
    .isr_we_o      (isr_we),
    .isr_wdata_o   (isr_wdata),
    .isr_wstrb_o   (isr_wstrb),
    .isr_re_o      (isr_re),
    .isr_rdata_i   ({30'b0, isr}),
    .ier_channel1_o(ier[0]),
    .ier_channel2_o(ier[1])
  );

  axi_gpio_core u_core (
    .clk_i(clk_gated_i),
    .rst_ni,
    .gpio_i  (data2),
    .gpio_o,
    .irq_o,
    .awake_o (core_awake),
    .data_i  (data),
    .tri_i   (tri_state),
    .enable_i(gier),
    .ier_i   (ier),
    .toggle_i(isr_toggle),
    .isr_o   (isr)
  );

  logic unused;
  assign unused = ^{isr_re, isr_wdata[31:2], isr_wstrb[3:1]};

endmodule
