// AXI4-Lite slave port of a register block: turns the five handshakes into one-cycle register strobes.
//
// Writes and reads are independent of each other; each direction has one transaction in flight. AW and W may come in
// either order with any skew; READY of a channel stays low from its handshake until the response has been taken, so a
// second request can never overtake the first. Every output of the AXI port is a flop, or the register file's read
// flop: no combinational path leads from an input to an output of that port.
//
//   clock         0          1         2           3
//   write    AW+W accepted   reg_we_o  reg_werr_i  BVALID
//   read     AR accepted     reg_re_o  RVALID (reg_rdata_i, reg_rerr_i)
//
// A response is OKAY, or SLVERR when the register file reports an error. An address beyond the block's registers is
// the register file's business; a wrong block is axi_lite_xbar's.
`include "assert.svh"

module axi_lite_slave #(
  parameter int AddrWidth = 16  // byte address bits of the block
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,  // synchronous

  // AXI4-Lite slave. AxPROT is not used.
  input  logic [AddrWidth-1:0] s_axi_awaddr_i,
  input  logic                 s_axi_awvalid_i,
  output logic                 s_axi_awready_o,
  input  logic [31:0]          s_axi_wdata_i,
  input  logic [3:0]           s_axi_wstrb_i,
  input  logic                 s_axi_wvalid_i,
  output logic                 s_axi_wready_o,
  output logic [1:0]           s_axi_bresp_o,
  output logic                 s_axi_bvalid_o,
  input  logic                 s_axi_bready_i,
  input  logic [AddrWidth-1:0] s_axi_araddr_i,
  input  logic                 s_axi_arvalid_i,
  output logic                 s_axi_arready_o,
  output logic [31:0]          s_axi_rdata_o,
  output logic [1:0]           s_axi_rresp_o,
  output logic                 s_axi_rvalid_o,
  input  logic                 s_axi_rready_i,

  // Register strobes. Addresses are passed on whole; the register file ignores bits 1:0.
  output logic                 reg_we_o,     // one clock per write, also when no byte is enabled
  output logic [AddrWidth-1:0] reg_waddr_o,
  output logic [31:0]          reg_wdata_o,
  output logic [3:0]           reg_wstrb_o,
  input  logic                 reg_werr_i,   // valid in the clock after reg_we_o
  output logic                 reg_re_o,     // one clock per read
  output logic [AddrWidth-1:0] reg_raddr_o,
  input  logic [31:0]          reg_rdata_i,  // valid from the clock after reg_re_o, held until the next reg_re_o
  input  logic                 reg_rerr_i    // as reg_rdata_i
);

  // Write: a READY that is low says that the request is held in reg_w*_o.
  logic werr_valid_q;  // reg_werr_i belongs to the write in flight
  logic berr_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      s_axi_awready_o <= 1'b1;
      s_axi_wready_o  <= 1'b1;
      s_axi_bvalid_o  <= 1'b0;
      reg_we_o        <= 1'b0;
      werr_valid_q    <= 1'b0;
      berr_q          <= 1'b0;
      reg_waddr_o     <= '0;
      reg_wdata_o     <= '0;
      reg_wstrb_o     <= '0;
    end else if (s_axi_awvalid_i || s_axi_wvalid_i || !s_axi_awready_o || !s_axi_wready_o) begin
      if (s_axi_awvalid_i && s_axi_awready_o) begin
        s_axi_awready_o <= 1'b0;
        reg_waddr_o     <= s_axi_awaddr_i;
      end
      if (s_axi_wvalid_i && s_axi_wready_o) begin
        s_axi_wready_o <= 1'b0;
        reg_wdata_o    <= s_axi_wdata_i;
        reg_wstrb_o    <= s_axi_wstrb_i;
      end
      // Each half is held or just being accepted, and not both were held before.
      reg_we_o <= (s_axi_awvalid_i || !s_axi_awready_o) && (s_axi_wvalid_i || !s_axi_wready_o) &&
                  (s_axi_awready_o || s_axi_wready_o);
      werr_valid_q <= reg_we_o;
      if (werr_valid_q) begin
        s_axi_bvalid_o <= 1'b1;
        berr_q         <= reg_werr_i;
      end
      if (s_axi_bvalid_o && s_axi_bready_i) begin
        s_axi_bvalid_o  <= 1'b0;
        s_axi_awready_o <= 1'b1;
        s_axi_wready_o  <= 1'b1;
      end
    end
  end

  assign s_axi_bresp_o = {berr_q, 1'b0};

  // Read: the register file holds the answer while R is stalled, because the next reg_re_o waits for it to be taken.
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      s_axi_arready_o <= 1'b1;
      s_axi_rvalid_o  <= 1'b0;
      reg_re_o        <= 1'b0;
      reg_raddr_o     <= '0;
    end else if (s_axi_arvalid_i || !s_axi_arready_o) begin
      reg_re_o <= s_axi_arready_o;
      if (s_axi_arready_o) begin
        s_axi_arready_o <= 1'b0;
        reg_raddr_o     <= s_axi_araddr_i;
      end
      if (reg_re_o) s_axi_rvalid_o <= 1'b1;
      if (s_axi_rvalid_o && s_axi_rready_i) begin
        s_axi_rvalid_o  <= 1'b0;
        s_axi_arready_o <= 1'b1;
      end
    end
  end

  assign s_axi_rdata_o = reg_rdata_i;
  assign s_axi_rresp_o = {reg_rerr_i, 1'b0};

  `ASSERT(BAnswersAHeldRequest, !s_axi_bvalid_o || !(s_axi_awready_o || s_axi_wready_o))
  `ASSERT(RAnswersAHeldRequest, !s_axi_rvalid_o || !s_axi_arready_o)
  `ASSERT(StrobesAWholeWrite, !reg_we_o || !(s_axi_awready_o || s_axi_wready_o || s_axi_bvalid_o))
  `ASSERT(HoldsReadDataWhileRWaits, !reg_re_o || !s_axi_rvalid_o)

  `COVER(AddressFirst, !s_axi_awready_o && s_axi_wready_o)
  `COVER(DataFirst, s_axi_awready_o && !s_axi_wready_o)
  `COVER(AddressAndDataAtOnce, s_axi_awvalid_i && s_axi_awready_o && s_axi_wvalid_i && s_axi_wready_o)
  `COVER(BWaits, s_axi_bvalid_o && !s_axi_bready_i)
  `COVER(RWaits, s_axi_rvalid_o && !s_axi_rready_i)
  `COVER(NextWriteWaits, s_axi_bvalid_o && s_axi_awvalid_i && s_axi_wvalid_i)
  `COVER(NextReadWaits, s_axi_rvalid_o && s_axi_arvalid_i)
  `COVER(WriteError, s_axi_bvalid_o && s_axi_bresp_o[1])
  `COVER(ReadError, s_axi_rvalid_o && s_axi_rresp_o[1])
  `COVER(WriteOfNoByte, reg_we_o && reg_wstrb_o == '0)
  `COVER(ReadWithWrite, reg_we_o && reg_re_o)

endmodule
