// Vo's encoder switch behind an AXI4-Lite port: six encoders in, the selected one out. Registers: encoder_switch_regs.toml.
//
// A plain multiplexer, as the paper has it: nothing tells the decoder behind it that the encoder has changed.
`include "assert.svh"

module encoder_switch (
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

  // Pins, one bit per axis, asynchronous.
  input  logic [5:0]  enc_a_i,
  input  logic [5:0]  enc_b_i,
  input  logic [5:0]  enc_z_i,

  // The selected encoder, one clock edge later. One flop only: it may be metastable for a while, and so these go to the
  // synchroniser of a decoder and nowhere else.
  output logic        enc_a_o,
  output logic        enc_b_o,
  output logic        enc_z_o
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

  logic [2:0] select;

  encoder_switch_reg_top u_regs (
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
    .select_axis_o(select)
  );

  (* ASYNC_REG = "TRUE" *) logic a_q, b_q, z_q;
  assign enc_a_o = a_q;
  assign enc_b_o = b_q;
  assign enc_z_o = z_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      a_q <= 1'b0;
      b_q <= 1'b0;
      z_q <= 1'b0;
    end else begin
      a_q <= enc_a_i[select] && select < 3'd6;
      b_q <= enc_b_i[select] && select < 3'd6;
      z_q <= enc_z_i[select] && select < 3'd6;
    end
  end

  `COVER(NobodySelected, select >= 3'd6)

endmodule
