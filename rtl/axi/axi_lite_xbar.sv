// AXI4-Lite address decoder: one slave port to NumSlaves master ports.
//
// Writes and reads take independent paths with one transaction in flight each, so every response belongs to the only
// request outstanding and a stalled read never blocks a write. A write is forwarded once both its address and its data
// have been accepted, in either order with any skew. Addresses that no master port claims are answered DECERR from
// here. All outputs are flops. A request reaches the slave two clocks after its acceptance; a response takes one clock
// back.
//
// Address and data outputs are shared by all master ports; only VALID and READY are per port. They are stable while a
// VALID is high and keep their last value otherwise.
`include "assert.svh"

module axi_lite_xbar #(
  parameter int NumSlaves = 2,
  parameter int SlaveAddrWidth = 16,  // low address bits passed on to the slaves
  // Port i, at [i*32 +: 32], claims addr when (addr & Mask) == Base. Claims must not overlap.
  parameter logic [NumSlaves*32-1:0] Base = '0,
  parameter logic [NumSlaves*32-1:0] Mask = '0
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,  // synchronous

  // Slave port, from the master
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

  // Master ports, to the slaves
  output logic [SlaveAddrWidth-1:0]   m_axi_awaddr_o,
  output logic [NumSlaves-1:0]        m_axi_awvalid_o,
  input  logic [NumSlaves-1:0]        m_axi_awready_i,
  output logic [31:0]                 m_axi_wdata_o,
  output logic [3:0]                  m_axi_wstrb_o,
  output logic [NumSlaves-1:0]        m_axi_wvalid_o,
  input  logic [NumSlaves-1:0]        m_axi_wready_i,
  input  logic [NumSlaves*2-1:0]      m_axi_bresp_i,
  input  logic [NumSlaves-1:0]        m_axi_bvalid_i,
  output logic [NumSlaves-1:0]        m_axi_bready_o,
  output logic [SlaveAddrWidth-1:0]   m_axi_araddr_o,
  output logic [NumSlaves-1:0]        m_axi_arvalid_o,
  input  logic [NumSlaves-1:0]        m_axi_arready_i,
  input  logic [NumSlaves*32-1:0]     m_axi_rdata_i,
  input  logic [NumSlaves*2-1:0]      m_axi_rresp_i,
  input  logic [NumSlaves-1:0]        m_axi_rvalid_i,
  output logic [NumSlaves-1:0]        m_axi_rready_o
);

  localparam logic [1:0] RespDecErr = 2'b11;

  initial if ((Base & ~Mask) != '0) $error("A Base has bits outside its Mask: that port can never be reached");

  // The master port that claims an address, one-hot; zero if none does.
  function automatic logic [NumSlaves-1:0] claim(input logic [31:0] addr);
    for (int i = 0; i < NumSlaves; i++) claim[i] = (addr & Mask[i*32+:32]) == Base[i*32+:32];
  endfunction

  // Write path. A READY that is low says that its half of the request is held in m_axi_*_o.
  logic                 write_busy_q;   // the held request has been forwarded or refused
  logic [NumSlaves-1:0] write_claim_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      s_axi_awready_o <= 1'b1;
      s_axi_wready_o  <= 1'b1;
      s_axi_bvalid_o  <= 1'b0;
      s_axi_bresp_o   <= '0;
      m_axi_awaddr_o  <= '0;
      m_axi_wdata_o   <= '0;
      m_axi_wstrb_o   <= '0;
      m_axi_awvalid_o <= '0;
      m_axi_wvalid_o  <= '0;
      m_axi_bready_o  <= '0;
      write_busy_q    <= 1'b0;
      write_claim_q   <= '0;
    end else if (s_axi_awvalid_i || s_axi_wvalid_i || !s_axi_awready_o || !s_axi_wready_o) begin
      if (s_axi_awvalid_i && s_axi_awready_o) begin
        s_axi_awready_o <= 1'b0;
        m_axi_awaddr_o  <= s_axi_awaddr_i[SlaveAddrWidth-1:0];
        write_claim_q   <= claim(s_axi_awaddr_i);
      end
      if (s_axi_wvalid_i && s_axi_wready_o) begin
        s_axi_wready_o <= 1'b0;
        m_axi_wdata_o  <= s_axi_wdata_i;
        m_axi_wstrb_o  <= s_axi_wstrb_i;
      end

      m_axi_awvalid_o <= m_axi_awvalid_o & ~m_axi_awready_i;
      m_axi_wvalid_o  <= m_axi_wvalid_o & ~m_axi_wready_i;
      if (!s_axi_awready_o && !s_axi_wready_o && !write_busy_q) begin
        write_busy_q    <= 1'b1;
        m_axi_awvalid_o <= write_claim_q;
        m_axi_wvalid_o  <= write_claim_q;
        m_axi_bready_o  <= write_claim_q;
        if (write_claim_q == '0) begin
          s_axi_bvalid_o <= 1'b1;
          s_axi_bresp_o  <= RespDecErr;
        end
      end
      if ((m_axi_bready_o & m_axi_bvalid_i) != '0) begin
        m_axi_bready_o <= '0;
        s_axi_bvalid_o <= 1'b1;
        for (int i = 0; i < NumSlaves; i++) if (m_axi_bready_o[i]) s_axi_bresp_o <= m_axi_bresp_i[i*2+:2];
      end
      if (s_axi_bvalid_o && s_axi_bready_i) begin
        s_axi_bvalid_o  <= 1'b0;
        s_axi_awready_o <= 1'b1;
        s_axi_wready_o  <= 1'b1;
        write_busy_q    <= 1'b0;
      end
    end
  end

  // Read path, in the same steps.
  logic                 read_busy_q;
  logic [NumSlaves-1:0] read_claim_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      s_axi_arready_o <= 1'b1;
      s_axi_rvalid_o  <= 1'b0;
      s_axi_rdata_o   <= '0;
      s_axi_rresp_o   <= '0;
      m_axi_araddr_o  <= '0;
      m_axi_arvalid_o <= '0;
      m_axi_rready_o  <= '0;
      read_busy_q     <= 1'b0;
      read_claim_q    <= '0;
    end else if (s_axi_arvalid_i || !s_axi_arready_o) begin
      if (s_axi_arready_o) begin
        s_axi_arready_o <= 1'b0;
        m_axi_araddr_o  <= s_axi_araddr_i[SlaveAddrWidth-1:0];
        read_claim_q    <= claim(s_axi_araddr_i);
      end

      m_axi_arvalid_o <= m_axi_arvalid_o & ~m_axi_arready_i;
      if (!s_axi_arready_o && !read_busy_q) begin
        read_busy_q     <= 1'b1;
        m_axi_arvalid_o <= read_claim_q;
        m_axi_rready_o  <= read_claim_q;
        if (read_claim_q == '0) begin
          s_axi_rvalid_o <= 1'b1;
          s_axi_rresp_o  <= RespDecErr;
          s_axi_rdata_o  <= '0;
        end
      end
      if ((m_axi_rready_o & m_axi_rvalid_i) != '0) begin
        m_axi_rready_o <= '0;
        s_axi_rvalid_o <= 1'b1;
        for (int i = 0; i < NumSlaves; i++) begin
          if (m_axi_rready_o[i]) begin
            s_axi_rdata_o <= m_axi_rdata_i[i*32+:32];
            s_axi_rresp_o <= m_axi_rresp_i[i*2+:2];
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

  `ASSERT(OneSlavePerWrite, $onehot0(m_axi_bready_o))
  `ASSERT(OneSlavePerRead, $onehot0(m_axi_rready_o))
  `ASSERT(BOnlyFromTheSlaveAsked, (m_axi_bvalid_i & ~m_axi_bready_o) == '0)
  `ASSERT(ROnlyFromTheSlaveAsked, (m_axi_rvalid_i & ~m_axi_rready_o) == '0)
  `ASSERT(BAfterTheWholeRequest, (m_axi_bvalid_i & (m_axi_awvalid_o | m_axi_wvalid_o)) == '0)

  `COVER(AddressFirst, !s_axi_awready_o && s_axi_wready_o)
  `COVER(DataFirst, s_axi_awready_o && !s_axi_wready_o)
  `COVER(WriteOfNobody, s_axi_bvalid_o && s_axi_bresp_o == RespDecErr)
  `COVER(ReadOfNobody, s_axi_rvalid_o && s_axi_rresp_o == RespDecErr)
  `COVER(WriteErrorOfASlave, s_axi_bvalid_o && s_axi_bresp_o == 2'b10)
  `COVER(ReadErrorOfASlave, s_axi_rvalid_o && s_axi_rresp_o == 2'b10)
  `COVER(BWaits, s_axi_bvalid_o && !s_axi_bready_i)
  `COVER(RWaits, s_axi_rvalid_o && !s_axi_rready_i)
  `COVER(SlaveTakesAddressFirst, m_axi_awvalid_o == '0 && m_axi_wvalid_o != '0)
  `COVER(SlaveTakesDataFirst, m_axi_awvalid_o != '0 && m_axi_wvalid_o == '0)
  `COVER(ReadOfOneSlaveDuringAWriteOfAnother, m_axi_bready_o != '0 && m_axi_rready_o != '0 &&
         m_axi_bready_o != m_axi_rready_o)

endmodule
