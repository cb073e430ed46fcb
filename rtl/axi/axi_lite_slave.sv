// AXI4-Lite slave port of a register block. It turns the five channel handshakes into one-cycle register strobes.
//
// Writes and reads are independent. Each direction has one transaction in flight. AW and W may arrive in either order
// with any skew. READY of a channel stays low from its handshake until the response has been accepted, so a second
// request can never overtake the first. Every output of the AXI port is a flop, or the read-data flop of the register
// file: there is no combinational path from an input to an output of that port.
//
//   clock         0          1         2           3
//   write    AW+W accepted   reg_we_o  reg_werr_i  BVALID
//   read     AR accepted     reg_re_o  RVALID (reg_rdata_i, reg_rerr_i)
//
// The response is OKAY, or SLVERR when the register file reports an error. The register file checks the address inside
// the block. axi_lite_xbar answers addresses outside of every block.
`include "assert.svh"
`include "axi_lite_types.svh"
`include "reg_access_types.svh"

module axi_lite_slave (
  input  logic          clk_i,
  input  logic          rst_ni,    // synchronous
  output logic          active_o,  // clock request; 0: the next edge changes no flop

  /* verilator tracing_off */
  input  axi_lite_req_t s_axi_i,
  output axi_lite_rsp_t s_axi_o,
  output reg_req_t      reg_o,
  input  reg_rsp_t      reg_i
  /* verilator tracing_on */
);

  // One net per member: a process that uses part of a struct takes more simulation time than one that uses a net.
  logic        awvalid, wvalid, bready, arvalid, rready;
  logic [15:0] awaddr, araddr;
  logic [31:0] wdata;
  logic [3:0]  wstrb;
  assign awaddr  = s_axi_i.awaddr;
  assign awvalid = s_axi_i.awvalid;
  assign wdata   = s_axi_i.wdata;
  assign wstrb   = s_axi_i.wstrb;
  assign wvalid  = s_axi_i.wvalid;
  assign bready  = s_axi_i.bready;
  assign araddr  = s_axi_i.araddr;
  assign arvalid = s_axi_i.arvalid;
  assign rready  = s_axi_i.rready;

  logic        awready_q, wready_q, bvalid_q, arready_q, rvalid_q;
  logic        berr_q, reg_we_q, reg_re_q, reg_werr, reg_rerr;
  logic [15:0] reg_waddr_q, reg_raddr_q;
  logic [31:0] reg_wdata_q;
  logic [3:0]  reg_wstrb_q;
  assign s_axi_o.awready = awready_q;
  assign s_axi_o.wready  = wready_q;
  assign s_axi_o.bresp   = {berr_q, 1'b0};
  assign s_axi_o.bvalid  = bvalid_q;
  assign s_axi_o.arready = arready_q;
  assign s_axi_o.rdata   = reg_i.rdata;
  assign s_axi_o.rresp   = {reg_rerr, 1'b0};
  assign s_axi_o.rvalid  = rvalid_q;
  assign reg_o.we        = reg_we_q;
  assign reg_o.waddr     = reg_waddr_q;
  assign reg_o.wdata     = reg_wdata_q;
  assign reg_o.wstrb     = reg_wstrb_q;
  assign reg_o.re        = reg_re_q;
  assign reg_o.raddr     = reg_raddr_q;
  assign reg_werr        = reg_i.werr;
  assign reg_rerr        = reg_i.rerr;

  // Idle: no request is held, and none is offered.
  assign active_o = awvalid || wvalid || arvalid || !(awready_q && wready_q && arready_q);

  // Write: a low READY means that this part of the request is held in reg_w*_q.
  logic werr_valid_q;  // reg_werr belongs to the write in flight

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      awready_q    <= 1'b1;
      wready_q     <= 1'b1;
      bvalid_q     <= 1'b0;
      reg_we_q     <= 1'b0;
      werr_valid_q <= 1'b0;
      berr_q       <= 1'b0;
      reg_waddr_q  <= '0;
      reg_wdata_q  <= '0;
      reg_wstrb_q  <= '0;
    end else if (awvalid || wvalid || !awready_q || !wready_q) begin
      if (awvalid && awready_q) begin
        awready_q   <= 1'b0;
        reg_waddr_q <= awaddr;
      end
      if (wvalid && wready_q) begin
        wready_q    <= 1'b0;
        reg_wdata_q <= wdata;
        reg_wstrb_q <= wstrb;
      end
      // Address and data are held or accepted in this clock, and at least one of them is new.
      reg_we_q <= (awvalid || !awready_q) && (wvalid || !wready_q) &&
                  (awready_q || wready_q);
      werr_valid_q <= reg_we_q;
      if (werr_valid_q) begin
        bvalid_q <= 1'b1;
        berr_q   <= reg_werr;
      end
      if (bvalid_q && bready) begin
        bvalid_q  <= 1'b0;
        awready_q <= 1'b1;
        wready_q  <= 1'b1;
      end
    end
  end

  // Read: the register file holds its data while R is stalled, because reg_re_q stays 0 until RREADY accepts them.
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      arready_q   <= 1'b1;
      rvalid_q    <= 1'b0;
      reg_re_q    <= 1'b0;
      reg_raddr_q <= '0;
    end else if (arvalid || !arready_q) begin
      reg_re_q <= arready_q;
      if (arready_q) begin
        arready_q   <= 1'b0;
        reg_raddr_q <= araddr;
      end
      if (reg_re_q) rvalid_q <= 1'b1;
      if (rvalid_q && rready) begin
        rvalid_q  <= 1'b0;
        arready_q <= 1'b1;
      end
    end
  end

  `ASSERT(BAnswersAHeldRequest, !bvalid_q || !(awready_q || wready_q))
  `ASSERT(RAnswersAHeldRequest, !rvalid_q || !arready_q)
  `ASSERT(StrobesAWholeWrite, !reg_we_q || !(awready_q || wready_q || bvalid_q))
  `ASSERT(HoldsReadDataWhileRWaits, !reg_re_q || !rvalid_q)

  `COVER(AddressFirst, !awready_q && wready_q)
  `COVER(DataFirst, awready_q && !wready_q)
  `COVER(AddressAndDataAtOnce, awvalid && awready_q && wvalid && wready_q)
  `COVER(BWaits, bvalid_q && !bready)
  `COVER(RWaits, rvalid_q && !rready)
  `COVER(NextWriteWaits, bvalid_q && awvalid && wvalid)
  `COVER(NextReadWaits, rvalid_q && arvalid)
  `COVER(WriteError, bvalid_q && berr_q)
  `COVER(ReadError, rvalid_q && reg_rerr)
  `COVER(WriteOfNoByte, reg_we_q && reg_wstrb_q == '0)
  `COVER(ReadWithWrite, reg_we_q && reg_re_q)

endmodule
