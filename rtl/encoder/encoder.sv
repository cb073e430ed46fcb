// Debounced quadrature decoders behind an AXI4-Lite port: bus, register file and core, wiring only.
// Registers: encoder_regs.toml. Those of axes that the block does not have read 0, and what is written there has no use.
module encoder #(
  parameter int                 Axes          = 6,  // 1..6
  parameter logic signed [31:0] PositionReset = 0   // start value of the positions, for tests of their wrap
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

  input  logic        trigger_i,  // one cycle per tick

  // Pins, one bit per axis, asynchronous.
  input  logic [Axes-1:0] enc_a_i,
  input  logic [Axes-1:0] enc_b_i,
  input  logic [Axes-1:0] enc_z_i
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

  localparam int MapAxes = 6;  // elements of the register map

  logic [7:0]            debounce_time;
  logic                  filter_mode, id_re;
  logic [MapAxes-1:0]    index_check, illegal, index;
  logic [MapAxes*24-1:0] counts_per_rev;
  logic [31:0]           trigger_time;
  logic [Axes-1:0]       illegal_set, index_set, index_seen, known;
  logic [Axes*32-1:0]    position, edge_time, index_position;
  logic [Axes*16-1:0]    illegal_count, glitch_count;
  logic [2*32-1:0]       fault_time;

  encoder_reg_top u_regs (
    .clk_i,
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
    .id_re_o               (id_re),
    .id_rdata_i            ({encoder_reg_pkg::IdBlockReset, encoder_reg_pkg::IdVersionReset, 8'(Axes)}),
    .debounce_time_o       (debounce_time),
    .index_check_enable_o  (index_check),
    .filter_mode_o         (filter_mode),
    .fault_illegal_set_i   (MapAxes'(illegal_set)),
    .fault_illegal_o       (illegal),
    .fault_index_set_i     (MapAxes'(index_set)),
    .fault_index_o         (index),
    .trigger_time_cycles_i (trigger_time),
    .index_seen_axes_i     (MapAxes'(index_seen)),
    .known_axes_i          (MapAxes'(known)),
    .position_value_i      ((MapAxes*32)'(position)),
    .edge_time_cycles_i    ((MapAxes*32)'(edge_time)),
    .index_position_value_i((MapAxes*32)'(index_position)),
    .counts_per_rev_value_o(counts_per_rev),
    .illegal_count_value_i ((MapAxes*16)'(illegal_count)),
    .glitch_count_value_i  ((MapAxes*16)'(glitch_count)),
    .fault_time_cycles_i   (fault_time)
  );

  encoder_core #(.Axes(Axes), .PositionReset(PositionReset)) u_core (
    .clk_i,
    .rst_ni,
    .trigger_i,
    .enc_a_i,
    .enc_b_i,
    .enc_z_i,
    .debounce_time_i (debounce_time),
    .filter_mode_i   (filter_mode),
    .index_check_i   (index_check[Axes-1:0]),
    .counts_per_rev_i(counts_per_rev[Axes*24-1:0]),
    .position_o      (position),
    .edge_time_o     (edge_time),
    .trigger_time_o  (trigger_time),
    .known_o         (known),
    .index_position_o(index_position),
    .index_seen_o    (index_seen),
    .illegal_count_o (illegal_count),
    .glitch_count_o  (glitch_count),
    .illegal_set_o   (illegal_set),
    .index_set_o     (index_set),
    .illegal_i       (illegal[Axes-1:0]),
    .index_i         (index[Axes-1:0]),
    .fault_time_o    (fault_time)
  );

  // What the register file has for axes that the block does not have, and the read strobe of a constant.
  logic unused;
  if (Axes < MapAxes) begin : gen_unused
    assign unused = ^{id_re, index_check[MapAxes-1:Axes], counts_per_rev[MapAxes*24-1:Axes*24],
                      illegal[MapAxes-1:Axes], index[MapAxes-1:Axes]};
  end else begin : gen_unused
    assign unused = id_re;
  end

endmodule
