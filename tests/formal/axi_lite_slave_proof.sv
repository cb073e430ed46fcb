// axi_lite_slave with an abstract register file: any register file that keeps the contract of the port. The proofs of
// the register files show that they keep it.
//
// In addition to the rules of AXI4-Lite, each write and each read gives exactly one strobe with the accepted payload.
// The response is that of this strobe, also if the registers change while the response is stalled.
`include "assert.svh"
`default_nettype none

module axi_lite_slave_proof (
  input wire         clk_i,
  input wire         rst_ni,
  input wire [15:0]  s_axi_awaddr_i,
  input wire         s_axi_awvalid_i,
  input wire [31:0]  s_axi_wdata_i,
  input wire [3:0]   s_axi_wstrb_i,
  input wire         s_axi_wvalid_i,
  input wire         s_axi_bready_i,
  input wire [15:0]  s_axi_araddr_i,
  input wire         s_axi_arvalid_i,
  input wire         s_axi_rready_i,
  input wire         reg_werr_i,
  input wire [31:0]  reg_rdata_i,
  input wire         reg_rerr_i
);

  logic        s_axi_awready_o, s_axi_wready_o, s_axi_bvalid_o, s_axi_arready_o, s_axi_rvalid_o;
  logic [1:0]  s_axi_bresp_o, s_axi_rresp_o;
  logic [31:0] s_axi_rdata_o;
  logic        reg_we_o, reg_re_o;
  logic [15:0] reg_waddr_o, reg_raddr_o;
  logic [31:0] reg_wdata_o;
  logic [3:0]  reg_wstrb_o;

  logic        active_o;

  axi_lite_slave_flat u_dut (.*);

  `RESET_FIRST

  axi_lite_properties u_rules (
    .clk_i, .rst_ni,
    .awaddr(s_axi_awaddr_i), .awvalid(s_axi_awvalid_i), .awready(s_axi_awready_o),
    .wdata(s_axi_wdata_i), .wstrb(s_axi_wstrb_i), .wvalid(s_axi_wvalid_i), .wready(s_axi_wready_o),
    .bresp(s_axi_bresp_o), .bvalid(s_axi_bvalid_o), .bready(s_axi_bready_i),
    .araddr(s_axi_araddr_i), .arvalid(s_axi_arvalid_i), .arready(s_axi_arready_o),
    .rdata(s_axi_rdata_o), .rresp(s_axi_rresp_o), .rvalid(s_axi_rvalid_o), .rready(s_axi_rready_i)
  );

  // The register file holds its read data until the next read strobe.
  logic        read_again_q;
  logic [31:0] rdata_before_q;
  logic        rerr_before_q;
  always_ff @(posedge clk_i) begin
    read_again_q   <= !rst_ni || reg_re_o;
    rdata_before_q <= reg_rdata_i;
    rerr_before_q  <= reg_rerr_i;
  end
  `ASSUME(ReadDataHolds, read_again_q || (reg_rdata_i == rdata_before_q && reg_rerr_i == rerr_before_q))

  // Writes.
  logic        aw_q, w_q, strobed_q, strobe_before_q, werr_q;
  logic [15:0] awaddr_q;
  logic [31:0] wdata_q;
  logic [3:0]  wstrb_q;
  logic        b_done;
  assign b_done = s_axi_bvalid_o && s_axi_bready_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {aw_q, w_q, strobed_q, strobe_before_q} <= '0;
    end else begin
      if (b_done) {aw_q, w_q, strobed_q} <= '0;
      if (s_axi_awvalid_i && s_axi_awready_o) {aw_q, awaddr_q} <= {1'b1, s_axi_awaddr_i};
      if (s_axi_wvalid_i && s_axi_wready_o) {w_q, wdata_q, wstrb_q} <= {1'b1, s_axi_wdata_i, s_axi_wstrb_i};
      if (reg_we_o) strobed_q <= 1'b1;
      strobe_before_q <= reg_we_o;
    end
    if (strobe_before_q) werr_q <= reg_werr_i;
  end
  `ASSERT(StrobesAWholeWrite, !reg_we_o || (aw_q && w_q))
  `ASSERT(StrobesAWriteAtMostOnce, !(reg_we_o && strobed_q))
  `ASSERT(StrobesAWriteBeforeItsAnswer, !s_axi_bvalid_o || strobed_q)
  `ASSERT(WritesWhatWasAccepted,
          !reg_we_o || (reg_waddr_o == awaddr_q && reg_wdata_o == wdata_q && reg_wstrb_o == wstrb_q))
  `ASSERT(BrespIsOfItsStrobe, !s_axi_bvalid_o || s_axi_bresp_o == {werr_q, 1'b0})
  `REACH(WritesWithoutAByte, reg_we_o && reg_wstrb_o == '0)
  `REACH(BrespIsNoLongerLive, s_axi_bvalid_o && s_axi_bresp_o[1] != reg_werr_i)

  // Reads.
  logic        ar_q, read_q, read_before_q, rerr_q;
  logic [15:0] araddr_q;
  logic [31:0] rdata_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {ar_q, read_q, read_before_q} <= '0;
    end else begin
      if (s_axi_rvalid_o && s_axi_rready_i) {ar_q, read_q} <= '0;
      if (s_axi_arvalid_i && s_axi_arready_o) {ar_q, araddr_q} <= {1'b1, s_axi_araddr_i};
      if (reg_re_o) read_q <= 1'b1;
      read_before_q <= reg_re_o;
    end
    if (read_before_q) {rerr_q, rdata_q} <= {reg_rerr_i, reg_rdata_i};
  end
  `ASSERT(StrobesAnAcceptedRead, !reg_re_o || (ar_q && reg_raddr_o == araddr_q))
  `ASSERT(StrobesAReadAtMostOnce, !(reg_re_o && read_q))
  `ASSERT(StrobesAReadBeforeItsAnswer, !s_axi_rvalid_o || read_q)
  `ASSERT(RdataIsOfItsStrobe,
          !s_axi_rvalid_o || read_before_q || (s_axi_rdata_o == rdata_q && s_axi_rresp_o == {rerr_q, 1'b0}))
  `ASSERT(RdataIsThatOfTheRegisters, !s_axi_rvalid_o || s_axi_rdata_o == reg_rdata_i)

endmodule

`default_nettype wire
