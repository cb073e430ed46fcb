// AXI4-Lite address decoder: one slave port to NumSlaves master ports.
//
// The write and the read path are independent and have one transaction in flight each. Every response therefore belongs
// to the one outstanding request, and a stalled read never blocks a write. A write is forwarded after both its address
// and its data have been accepted, in either order with any skew. The decoder itself answers DECERR to an address that
// no master port claims. All outputs are flops. A request reaches the slave two clocks after its acceptance. A response
// takes one clock back.
//
// A bus watchdog limits the time of a slave. If it has not answered TimeoutClocks clocks after a request was sent to
// it, the crossbar answers SLVERR, withdraws the request, ignores the port and answers SLVERR to all further requests
// for it until reset: the master never waits for good, and the other ports are not affected. A late response belongs to
// no request and is ignored. A slave that shows a response before it has accepted the whole request, as one does whose
// clock stopped during its last response, is given up in the same way at once.
//
// Address and data outputs are shared by all master ports; VALID and READY are per port. Address and data are stable
// while a VALID is high and keep their last value otherwise.
`include "assert.svh"
`include "axi_lite_types.svh"

module axi_lite_xbar #(
  parameter int NumSlaves = 2,
  parameter int TimeoutClocks = 128,  // 1..255, more than any working slave needs
  // Port i, at [i*32 +: 32], claims addr when (addr & Mask) == Base. Claims must not overlap.
  parameter logic [NumSlaves*32-1:0] Base = '0,
  parameter logic [NumSlaves*32-1:0] Mask = '0
) (
  input  logic                        clk_i,     // may be gated, see active_o
  input  logic                        rst_ni,    // synchronous
  output logic                        active_o,  // clock request. 0 and no s_axi_*valid_i: no flop changes

  // Slave port, connected to the master
  input  logic [31:0]                 s_axi_awaddr_i,
  input  logic                        s_axi_awvalid_i,
  output logic                        s_axi_awready_o,
  input  logic [31:0]                 s_axi_wdata_i,
  input  logic [3:0]                  s_axi_wstrb_i,
  input  logic                        s_axi_wvalid_i,
  output logic                        s_axi_wready_o,
  output logic [1:0]                  s_axi_bresp_o,
  output logic                        s_axi_bvalid_o,
  input  logic                        s_axi_bready_i,
  input  logic [31:0]                 s_axi_araddr_i,
  input  logic                        s_axi_arvalid_i,
  output logic                        s_axi_arready_o,
  output logic [31:0]                 s_axi_rdata_o,
  output logic [1:0]                  s_axi_rresp_o,
  output logic                        s_axi_rvalid_o,
  input  logic                        s_axi_rready_i,

  // Master ports, connected to the slaves; port i at [i*W +: W]
  /* verilator tracing_off */
  output logic [NumSlaves*AxiLiteReqBits-1:0] m_axi_o,
  input  logic [NumSlaves*AxiLiteRspBits-1:0] m_axi_i
  /* verilator tracing_on */
);

  assign active_o = !(s_axi_awready_o && s_axi_wready_o && s_axi_arready_o);  // a request is held

  localparam logic [1:0] RespSlvErr = 2'b10, RespDecErr = 2'b11;

  initial if ((Base & ~Mask) != '0) $error("A Base has bits outside its Mask: that port can never be reached");

  logic [15:0]             m_awaddr_q, m_araddr_q;
  logic [31:0]             m_wdata_q;
  logic [3:0]              m_wstrb_q;
  logic [NumSlaves-1:0]    m_awvalid_q, m_wvalid_q, m_bready_q, m_arvalid_q, m_rready_q;
  logic [NumSlaves-1:0]    m_awready, m_wready, m_bvalid, m_arready, m_rvalid;
  logic [NumSlaves*2-1:0]  m_bresp, m_rresp;
  logic [NumSlaves*32-1:0] m_rdata;

  // The members are in the order of axi_lite_types.svh.
  for (genvar i = 0; i < NumSlaves; i++) begin : gen_port
    assign m_axi_o[i*AxiLiteReqBits +: AxiLiteReqBits] = {
      m_awaddr_q, m_awvalid_q[i], m_wdata_q, m_wstrb_q, m_wvalid_q[i], m_bready_q[i], m_araddr_q, m_arvalid_q[i],
      m_rready_q[i]
    };
    assign {
      m_awready[i], m_wready[i], m_bresp[i*2+:2], m_bvalid[i], m_arready[i], m_rdata[i*32+:32], m_rresp[i*2+:2],
      m_rvalid[i]
    } = m_axi_i[i*AxiLiteRspBits +: AxiLiteRspBits];
  end

  // The master port that claims an address, one-hot; zero if none does.
  function automatic logic [NumSlaves-1:0] claim(input logic [31:0] addr);
    for (int i = 0; i < NumSlaves; i++) claim[i] = (addr & Mask[i*32+:32]) == Base[i*32+:32];
  endfunction

  // Bus watchdog: the clocks since a request was sent to its port, and the ports that were given up.
  logic [7:0]           write_wait_q, read_wait_q;
  logic [NumSlaves-1:0] hung_write_q, hung_read_q, hung;
  assign hung = hung_write_q | hung_read_q;

  // The port of the request in flight shows a response. Nobody asked for it while a part of the request still waits.
  logic write_shown, write_waits, read_shown, read_waits;
  assign write_shown = (m_bready_q & m_bvalid) != '0;
  assign write_waits = (m_awvalid_q | m_wvalid_q) != '0;
  assign read_shown  = (m_rready_q & m_rvalid) != '0;
  assign read_waits  = m_arvalid_q != '0;

  localparam logic [7:0] LastClock = 8'(TimeoutClocks - 1);

  // Write path. A low READY means that this part of the request is held in m_aw*_q or m_w*_q.
  logic                 write_busy_q;   // the held request has been forwarded or answered with DECERR
  logic [NumSlaves-1:0] write_claim_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      s_axi_awready_o <= 1'b1;
      s_axi_wready_o  <= 1'b1;
      s_axi_bvalid_o  <= 1'b0;
      s_axi_bresp_o   <= '0;
      m_awaddr_q      <= '0;
      m_wdata_q       <= '0;
      m_wstrb_q       <= '0;
      m_awvalid_q     <= '0;
      m_wvalid_q      <= '0;
      m_bready_q      <= '0;
      write_busy_q    <= 1'b0;
      write_claim_q   <= '0;
      write_wait_q    <= '0;
      hung_write_q    <= '0;
    end else if (s_axi_awvalid_i || s_axi_wvalid_i || !s_axi_awready_o || !s_axi_wready_o) begin
      if (s_axi_awvalid_i && s_axi_awready_o) begin
        s_axi_awready_o <= 1'b0;
        m_awaddr_q      <= s_axi_awaddr_i[15:0];
        write_claim_q   <= claim(s_axi_awaddr_i);
      end
      if (s_axi_wvalid_i && s_axi_wready_o) begin
        s_axi_wready_o <= 1'b0;
        m_wdata_q      <= s_axi_wdata_i;
        m_wstrb_q      <= s_axi_wstrb_i;
      end

      m_awvalid_q <= m_awvalid_q & ~m_awready;
      m_wvalid_q  <= m_wvalid_q & ~m_wready;
      if (!s_axi_awready_o && !s_axi_wready_o && !write_busy_q) begin
        write_busy_q <= 1'b1;
        m_awvalid_q  <= write_claim_q & ~hung;
        m_wvalid_q   <= write_claim_q & ~hung;
        m_bready_q   <= write_claim_q & ~hung;
        if ((write_claim_q & ~hung) == '0) begin
          s_axi_bvalid_o <= 1'b1;
          s_axi_bresp_o  <= write_claim_q == '0 ? RespDecErr : RespSlvErr;
        end
      end
      if (write_shown ? write_waits : write_wait_q == LastClock && m_bready_q != '0) begin
        hung_write_q   <= hung_write_q | m_bready_q;
        m_awvalid_q    <= '0;
        m_wvalid_q     <= '0;
        m_bready_q     <= '0;
        s_axi_bvalid_o <= 1'b1;
        s_axi_bresp_o  <= RespSlvErr;
      end
      write_wait_q <= m_bready_q == '0 ? '0 : write_wait_q + 8'd1;
      if (write_shown && !write_waits) begin
        m_bready_q     <= '0;
        s_axi_bvalid_o <= 1'b1;
        for (int i = 0; i < NumSlaves; i++) if (m_bready_q[i]) s_axi_bresp_o <= m_bresp[i*2+:2];
      end
      if (s_axi_bvalid_o && s_axi_bready_i) begin
        s_axi_bvalid_o  <= 1'b0;
        s_axi_awready_o <= 1'b1;
        s_axi_wready_o  <= 1'b1;
        write_busy_q    <= 1'b0;
      end
    end
  end

  // Read path, with the same sequence.
  logic                 read_busy_q;
  logic [NumSlaves-1:0] read_claim_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      s_axi_arready_o <= 1'b1;
      s_axi_rvalid_o  <= 1'b0;
      s_axi_rdata_o   <= '0;
      s_axi_rresp_o   <= '0;
      m_araddr_q      <= '0;
      m_arvalid_q     <= '0;
      m_rready_q      <= '0;
      read_busy_q     <= 1'b0;
      read_claim_q    <= '0;
      read_wait_q     <= '0;
      hung_read_q     <= '0;
    end else if (s_axi_arvalid_i || !s_axi_arready_o) begin
      if (s_axi_arready_o) begin
        s_axi_arready_o <= 1'b0;
        m_araddr_q      <= s_axi_araddr_i[15:0];
        read_claim_q    <= claim(s_axi_araddr_i);
      end

      m_arvalid_q <= m_arvalid_q & ~m_arready;
      if (!s_axi_arready_o && !read_busy_q) begin
        read_busy_q <= 1'b1;
        m_arvalid_q <= read_claim_q & ~hung;
        m_rready_q  <= read_claim_q & ~hung;
        if ((read_claim_q & ~hung) == '0) begin
          s_axi_rvalid_o <= 1'b1;
          s_axi_rresp_o  <= read_claim_q == '0 ? RespDecErr : RespSlvErr;
          s_axi_rdata_o  <= '0;
        end
      end
      if (read_shown ? read_waits : read_wait_q == LastClock && m_rready_q != '0) begin
        hung_read_q    <= hung_read_q | m_rready_q;
        m_arvalid_q    <= '0;
        m_rready_q     <= '0;
        s_axi_rvalid_o <= 1'b1;
        s_axi_rresp_o  <= RespSlvErr;
        s_axi_rdata_o  <= '0;
      end
      read_wait_q <= m_rready_q == '0 ? '0 : read_wait_q + 8'd1;
      if (read_shown && !read_waits) begin
        m_rready_q     <= '0;
        s_axi_rvalid_o <= 1'b1;
        for (int i = 0; i < NumSlaves; i++) begin
          if (m_rready_q[i]) begin
            s_axi_rdata_o <= m_rdata[i*32+:32];
            s_axi_rresp_o <= m_rresp[i*2+:2];
          end
        end
      end
      if (s_axi_rvalid_o && s_axi_rready_i) begin
        s_axi_rvalid_o  <= 1'b0;
        s_axi_arready_o <= 1'b1;
        read_busy_q     <= 1'b0;
      end
    end
  end

  `ASSERT(OneSlavePerWrite, $onehot0(m_bready_q))
  `ASSERT(OneSlavePerRead, $onehot0(m_rready_q))
  `ASSERT(NothingToAHungPort, ((m_awvalid_q | m_wvalid_q | m_arvalid_q) & hung & ~(m_bready_q | m_rready_q)) == '0)

  `COVER(AddressFirst, !s_axi_awready_o && s_axi_wready_o)
  `COVER(DataFirst, s_axi_awready_o && !s_axi_wready_o)
  `COVER(WriteUnclaimed, s_axi_bvalid_o && s_axi_bresp_o == RespDecErr)
  `COVER(ReadUnclaimed, s_axi_rvalid_o && s_axi_rresp_o == RespDecErr)
  `COVER(WriteErrorOfASlave, s_axi_bvalid_o && s_axi_bresp_o == 2'b10)
  `COVER(ReadErrorOfASlave, s_axi_rvalid_o && s_axi_rresp_o == 2'b10)
  `COVER(WriteTimeout, write_wait_q == LastClock && m_bready_q != '0 && !write_shown)
  `COVER(ReadTimeout, read_wait_q == LastClock && m_rready_q != '0 && !read_shown)
  `COVER(WriteUnasked, write_shown && write_waits)
  `COVER(ReadUnasked, read_shown && read_waits)
  `COVER(WriteToAHungPort, write_busy_q && (write_claim_q & hung) != '0)
  `COVER(ReadFromAHungPort, read_busy_q && (read_claim_q & hung) != '0)
  `COVER(BWaits, s_axi_bvalid_o && !s_axi_bready_i)
  `COVER(RWaits, s_axi_rvalid_o && !s_axi_rready_i)
  `COVER(SlaveAcceptsAddressFirst, m_awvalid_q == '0 && m_wvalid_q != '0)
  `COVER(SlaveAcceptsDataFirst, m_awvalid_q != '0 && m_wvalid_q == '0)
  `COVER(ReadOfOneSlaveDuringAWriteOfAnother, m_bready_q != '0 && m_rready_q != '0 &&
         m_bready_q != m_rready_q)

endmodule
