// The bus watchdog of axi_lite_xbar, with one port whose slave may stop accepting and answering at any time, answer
// late or not hold its answers, and one whose slave keeps the rules.
//
// The master gets every response in a bounded time. The slave of port 0 cannot disturb accesses to port 1. After a
// time-out nothing is sent to port 0 any more, and every access to it is answered SLVERR.
`include "assert.svh"
`default_nettype none

module axi_lite_xbar_hang_proof #(
  parameter int Ports = 2,
  parameter int TimeoutClocks = 8,
  parameter logic [Ports*32-1:0] Base = 64'h4000_0000_0000_0000,
  parameter logic [Ports*32-1:0] Mask = 64'hC000_0000_C000_0000
) (
`include "axi_lite_xbar_inputs.svh"
);

`include "axi_lite_xbar_outputs.svh"

  axi_lite_xbar_flat #(.NumSlaves(Ports), .TimeoutClocks(TimeoutClocks), .Base(Base), .Mask(Mask)) u_dut (.*);

  `RESET_FIRST

  // From the acceptance of the whole request: one clock to send it, the time-out, one clock back.
  axi_lite_properties #(.AddrWidth(32), .MaxReady(0), .MaxResponse(TimeoutClocks + 2), .MayDecErr(1'b1)) u_master (
    .clk_i, .rst_ni,
    .awaddr(s_axi_awaddr_i), .awvalid(s_axi_awvalid_i), .awready(s_axi_awready_o),
    .wdata(s_axi_wdata_i), .wstrb(s_axi_wstrb_i), .wvalid(s_axi_wvalid_i), .wready(s_axi_wready_o),
    .bresp(s_axi_bresp_o), .bvalid(s_axi_bvalid_o), .bready(s_axi_bready_i),
    .araddr(s_axi_araddr_i), .arvalid(s_axi_arvalid_i), .arready(s_axi_arready_o),
    .rdata(s_axi_rdata_o), .rresp(s_axi_rresp_o), .rvalid(s_axi_rvalid_o), .rready(s_axi_rready_i)
  );

  axi_lite_properties #(
    .AssumeMaster(1'b0), .AssumeSlave(1'b1), .MaxReady(1), .MaxResponse(3), .MayStall(1'b0)
  ) u_slave (
    .clk_i, .rst_ni,
    .awaddr(m_axi_awaddr_o[16+:16]), .awvalid(m_axi_awvalid_o[1]), .awready(m_axi_awready_i[1]),
    .wdata(m_axi_wdata_o[32+:32]), .wstrb(m_axi_wstrb_o[4+:4]),
    .wvalid(m_axi_wvalid_o[1]), .wready(m_axi_wready_i[1]),
    .bresp(m_axi_bresp_i[2+:2]), .bvalid(m_axi_bvalid_i[1]), .bready(m_axi_bready_o[1]),
    .araddr(m_axi_araddr_o[16+:16]), .arvalid(m_axi_arvalid_o[1]), .arready(m_axi_arready_i[1]),
    .rdata(m_axi_rdata_i[32+:32]), .rresp(m_axi_rresp_i[2+:2]), .rvalid(m_axi_rvalid_i[1]),
    .rready(m_axi_rready_o[1])
  );

  // The slave of port 0 answers only what it has accepted, with a legal code.
  logic aw0_q, w0_q, ar0_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) {aw0_q, w0_q, ar0_q} <= '0;
    else begin
      if (m_axi_bvalid_i[0] && m_axi_bready_o[0]) {aw0_q, w0_q} <= '0;
      else {aw0_q, w0_q} <= {aw0_q, w0_q} |
          {m_axi_awvalid_o[0] && m_axi_awready_i[0], m_axi_wvalid_o[0] && m_axi_wready_i[0]};
      if (m_axi_rvalid_i[0] && m_axi_rready_o[0]) ar0_q <= 1'b0;
      else ar0_q <= ar0_q || (m_axi_arvalid_o[0] && m_axi_arready_i[0]);
    end
  end
  `ASSUME(Port0AnswersAWholeWrite, !m_axi_bvalid_i[0] || (aw0_q && w0_q))
  `ASSUME(Port0AnswersARead, !m_axi_rvalid_i[0] || ar0_q)
  `ASSUME(BrespOfPort0IsLegal, m_axi_bresp_i[1:0] == 2'b00 || m_axi_bresp_i[1:0] == 2'b10)
  `ASSUME(RrespOfPort0IsLegal, m_axi_rresp_i[1:0] == 2'b00 || m_axi_rresp_i[1:0] == 2'b10)

  // Where the request in flight goes, and what port 1 has answered.
  logic [31:0] awaddr_q, araddr_q, rdata_q;
  logic [1:0]  bresp_q, rresp_q;
  always_ff @(posedge clk_i) begin
    if (s_axi_awvalid_i && s_axi_awready_o) awaddr_q <= s_axi_awaddr_i;
    if (s_axi_arvalid_i && s_axi_arready_o) araddr_q <= s_axi_araddr_i;
    if (m_axi_bvalid_i[1] && m_axi_bready_o[1]) bresp_q <= m_axi_bresp_i[3:2];
    if (m_axi_rvalid_i[1] && m_axi_rready_o[1]) {rresp_q, rdata_q} <= {m_axi_rresp_i[3:2], m_axi_rdata_i[63:32]};
  end
  `ASSERT(BrespOfPort1, !(s_axi_bvalid_o && awaddr_q[31:30] == 2'd1) || s_axi_bresp_o == bresp_q)
  `ASSERT(RrespOfPort1, !(s_axi_rvalid_o && araddr_q[31:30] == 2'd1) ||
          {s_axi_rresp_o, s_axi_rdata_o} == {rresp_q, rdata_q})
  `ASSERT(AwOnlyToItsPort, !m_axi_awvalid_o[1] || awaddr_q[31:30] == 2'd1)
  `ASSERT(ArOnlyToItsPort, !m_axi_arvalid_o[1] || araddr_q[31:30] == 2'd1)

  // Port 0 is given up when its READY falls without a response.
  logic bready_q, rready_q, b_q, r_q, given_up_q, given_up;
  assign given_up = given_up_q || (bready_q && !m_axi_bready_o[0] && !b_q) || (rready_q && !m_axi_rready_o[0] && !r_q);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) {bready_q, rready_q, b_q, r_q, given_up_q} <= '0;
    else {bready_q, rready_q, b_q, r_q, given_up_q} <=
        {m_axi_bready_o[0], m_axi_rready_o[0], m_axi_bvalid_i[0], m_axi_rvalid_i[0], given_up};
  end
  `ASSERT(NoNewWriteAfterATimeout, !(given_up_q && m_axi_bready_o[0] && !bready_q))
  `ASSERT(NoNewReadAfterATimeout, !(given_up_q && m_axi_rready_o[0] && !rready_q))

  logic write_sent_q, read_sent_q;  // the request in flight was sent to port 0
  always_ff @(posedge clk_i) begin
    if (!rst_ni || (s_axi_bvalid_o && s_axi_bready_i)) write_sent_q <= 1'b0;
    else if (m_axi_bready_o[0]) write_sent_q <= 1'b1;
    if (!rst_ni || (s_axi_rvalid_o && s_axi_rready_i)) read_sent_q <= 1'b0;
    else if (m_axi_rready_o[0]) read_sent_q <= 1'b1;
  end
  `ASSERT(WriteThatIsNotSentIsAnError,
          !(s_axi_bvalid_o && awaddr_q[31:30] == 2'd0 && !write_sent_q) || s_axi_bresp_o == 2'b10)
  `ASSERT(ReadThatIsNotSentIsAnError,
          !(s_axi_rvalid_o && araddr_q[31:30] == 2'd0 && !read_sent_q) ||
          (s_axi_rresp_o == 2'b10 && s_axi_rdata_o == '0))
  `REACH(Port1AnswersAfterATimeout, given_up_q && s_axi_bvalid_o && awaddr_q[31:30] == 2'd1 && s_axi_bresp_o == 2'b00)
  `REACH(HungPortIsRefused, given_up_q && s_axi_rvalid_o && araddr_q[31:30] == 2'd0 && !read_sent_q)
  `REACH(LateResponse, given_up_q && m_axi_bvalid_i[0] && !m_axi_bready_o[0])

endmodule

`default_nettype wire
