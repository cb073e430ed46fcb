// axi_lite_xbar with the blocks of arm_soc, between any master and any slaves that keep the rules of
// AXI4-Lite.
//
// In addition to the rules on all ports, a request goes once, unchanged, to the port that claims its address and to no
// other port. Its response is the response of that port. An unclaimed address is answered DECERR and reaches no port.
`include "assert.svh"
`default_nettype none

module axi_lite_xbar_proof #(
  parameter int Ports = soc_map_pkg::NumBlocks,
  parameter logic [Ports*32-1:0] Base = soc_map_pkg::XbarBase,
  parameter logic [Ports*32-1:0] Mask = soc_map_pkg::XbarMask
) (
`include "axi_lite_xbar_inputs.svh"
);

`include "axi_lite_xbar_outputs.svh"

  axi_lite_xbar_flat #(.NumSlaves(Ports), .Base(Base), .Mask(Mask)) u_dut (.*);

  `RESET_FIRST

  // Flops of u_dut and u_master, for the assertions that make the others inductive: they describe each reachable state.
`include "axi_lite_xbar_flops.svh"
  (* hierconn *) wire [7:0]       \u_master.b_wait_q , \u_master.r_wait_q ;
  logic             write_busy, read_busy;
  logic [7:0]       write_wait, read_wait;
  assign {write_busy, read_busy} = {\u_dut.u_flat.write_busy_q , \u_dut.u_flat.read_busy_q };
  assign {write_wait, read_wait} = {\u_dut.u_flat.write_wait_q , \u_dut.u_flat.read_wait_q };

  // Each slave may take one clock longer than the proved bound of the slaves; the crossbar adds three clocks.
  axi_lite_properties #(.AddrWidth(32), .MaxReady(0), .MaxResponse(7), .MayDecErr(1'b1)) u_master (
    .clk_i, .rst_ni,
    .awaddr(s_axi_awaddr_i), .awvalid(s_axi_awvalid_i), .awready(s_axi_awready_o),
    .wdata(s_axi_wdata_i), .wstrb(s_axi_wstrb_i), .wvalid(s_axi_wvalid_i), .wready(s_axi_wready_o),
    .bresp(s_axi_bresp_o), .bvalid(s_axi_bvalid_o), .bready(s_axi_bready_i),
    .araddr(s_axi_araddr_i), .arvalid(s_axi_arvalid_i), .arready(s_axi_arready_o),
    .rdata(s_axi_rdata_o), .rresp(s_axi_rresp_o), .rvalid(s_axi_rvalid_o), .rready(s_axi_rready_i)
  );

  for (genvar i = 0; i < Ports; i++) begin : gen_port
    axi_lite_properties #(
      .AssumeMaster(1'b0), .AssumeSlave(1'b1), .MaxReady(1), .MaxResponse(3), .MayStall(1'b0)
    ) u_slave (
      .clk_i, .rst_ni,
      .awaddr(m_axi_awaddr_o[i*16+:16]), .awvalid(m_axi_awvalid_o[i]), .awready(m_axi_awready_i[i]),
      .wdata(m_axi_wdata_o[i*32+:32]), .wstrb(m_axi_wstrb_o[i*4+:4]),
      .wvalid(m_axi_wvalid_o[i]), .wready(m_axi_wready_i[i]),
      .bresp(m_axi_bresp_i[i*2+:2]), .bvalid(m_axi_bvalid_i[i]), .bready(m_axi_bready_o[i]),
      .araddr(m_axi_araddr_o[i*16+:16]), .arvalid(m_axi_arvalid_o[i]), .arready(m_axi_arready_i[i]),
      .rdata(m_axi_rdata_i[i*32+:32]), .rresp(m_axi_rresp_i[i*2+:2]), .rvalid(m_axi_rvalid_i[i]),
      .rready(m_axi_rready_o[i])
    );

    // These wires are the flops of u_slave.
    (* hierconn *) wire       \u_slave.aw_q , \u_slave.w_q , \u_slave.ar_q ;
    (* hierconn *) wire [7:0] \u_slave.aw_wait_q , \u_slave.w_wait_q , \u_slave.b_wait_q ;
    (* hierconn *) wire [7:0] \u_slave.ar_wait_q , \u_slave.r_wait_q ;
    `ASSERT(SlaveHasWhatItAccepted, {\u_slave.aw_q , \u_slave.w_q , \u_slave.ar_q } ==
            {m_axi_bready_o[i] && !m_axi_awvalid_o[i], m_axi_bready_o[i] && !m_axi_wvalid_o[i],
             m_axi_rready_o[i] && !m_axi_arvalid_o[i]})
    `ASSERT(SlaveWaitsAreBounded, \u_slave.aw_wait_q <= 8'd1 && \u_slave.w_wait_q <= 8'd1 &&
            \u_slave.ar_wait_q <= 8'd1 && \u_slave.b_wait_q <= 8'd3 && \u_slave.r_wait_q <= 8'd3)
    `ASSERT(WatchdogCountsTheWrite, !m_axi_bready_o[i] || (
            (!m_axi_awvalid_o[i] || write_wait == \u_slave.aw_wait_q ) &&
            (!m_axi_wvalid_o[i] || write_wait == \u_slave.w_wait_q ) &&
            (m_axi_awvalid_o[i] || m_axi_wvalid_o[i] || write_wait <= \u_slave.b_wait_q + 8'd2)))
    `ASSERT(WatchdogCountsTheRead, !m_axi_rready_o[i] ||
            (m_axi_arvalid_o[i] ? read_wait == \u_slave.ar_wait_q : read_wait <= \u_slave.r_wait_q + 8'd2))
  end

  // The request in flight as accepted, the ports that received it, and the response.
  logic [31:0]      awaddr_q, araddr_q, wdata_q, rdata_q;
  logic [3:0]       wstrb_q;
  logic [1:0]       bresp_q, rresp_q;
  logic [Ports-1:0] aw_sent_q, w_sent_q, ar_sent_q, b_back_q, r_back_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {aw_sent_q, w_sent_q, b_back_q} <= '0;
      {ar_sent_q, r_back_q}           <= '0;
    end else begin
      if (s_axi_awvalid_i && s_axi_awready_o) awaddr_q <= s_axi_awaddr_i;
      if (s_axi_wvalid_i && s_axi_wready_o) {wdata_q, wstrb_q} <= {s_axi_wdata_i, s_axi_wstrb_i};
      if (s_axi_arvalid_i && s_axi_arready_o) araddr_q <= s_axi_araddr_i;
      if (s_axi_bvalid_o && s_axi_bready_i) {aw_sent_q, w_sent_q, b_back_q} <= '0;
      else begin
        aw_sent_q <= aw_sent_q | (m_axi_awvalid_o & m_axi_awready_i);
        w_sent_q  <= w_sent_q | (m_axi_wvalid_o & m_axi_wready_i);
        b_back_q  <= b_back_q | (m_axi_bvalid_i & m_axi_bready_o);
      end
      if (s_axi_rvalid_o && s_axi_rready_i) {ar_sent_q, r_back_q} <= '0;
      else begin
        ar_sent_q <= ar_sent_q | (m_axi_arvalid_o & m_axi_arready_i);
        r_back_q  <= r_back_q | (m_axi_rvalid_i & m_axi_rready_o);
      end
      for (int i = 0; i < Ports; i++) begin
        if (m_axi_bvalid_i[i] && m_axi_bready_o[i]) bresp_q <= m_axi_bresp_i[i*2+:2];
        if (m_axi_rvalid_i[i] && m_axi_rready_o[i])
          {rresp_q, rdata_q} <= {m_axi_rresp_i[i*2+:2], m_axi_rdata_i[i*32+:32]};
      end
    end
  end

  logic [Ports-1:0] write_claim, read_claim;
  for (genvar i = 0; i < Ports; i++) begin : gen_claim
    assign write_claim[i] = (awaddr_q & Mask[i*32+:32]) == Base[i*32+:32];
    assign read_claim[i]  = (araddr_q & Mask[i*32+:32]) == Base[i*32+:32];
  end

  `ASSERT(AwOnlyToItsPort, (m_axi_awvalid_o & ~write_claim) == '0)
  `ASSERT(WOnlyToItsPort, (m_axi_wvalid_o & ~write_claim) == '0)
  `ASSERT(ArOnlyToItsPort, (m_axi_arvalid_o & ~read_claim) == '0)
  // Checked on every port, also on those that are not addressed: all receive the same payload.
  `ASSERT(AwAsAccepted, m_axi_awvalid_o == '0 || m_axi_awaddr_o == {Ports{awaddr_q[15:0]}})
  `ASSERT(WAsAccepted, m_axi_wvalid_o == '0 || (m_axi_wdata_o == {Ports{wdata_q}} && m_axi_wstrb_o == {Ports{wstrb_q}}))
  `ASSERT(ArAsAccepted, m_axi_arvalid_o == '0 || m_axi_araddr_o == {Ports{araddr_q[15:0]}})
  `ASSERT(EachHalfOnce, (m_axi_awvalid_o & aw_sent_q) == '0 && (m_axi_wvalid_o & w_sent_q) == '0)
  `ASSERT(EachReadOnce, (m_axi_arvalid_o & ar_sent_q) == '0)
  `ASSERT(BAfterItsPort, !s_axi_bvalid_o || b_back_q == write_claim)
  `ASSERT(RAfterItsPort, !s_axi_rvalid_o || r_back_q == read_claim)
  `ASSERT(BrespOfItsPort, !s_axi_bvalid_o || s_axi_bresp_o == (write_claim == '0 ? 2'b11 : bresp_q))
  `ASSERT(RrespOfItsPort, !s_axi_rvalid_o || s_axi_rresp_o == (read_claim == '0 ? 2'b11 : rresp_q))
  `ASSERT(RdataOfItsPort, !s_axi_rvalid_o || s_axi_rdata_o == (read_claim == '0 ? 32'd0 : rdata_q))
  // The state of the crossbar. No slave is given up, because every slave answers in time.
  `ASSERT(NoPortIsHung, \u_dut.u_flat.hung == '0)
  `ASSERT(ReadyFallsWhileARequestIsHeld, {s_axi_awready_o, s_axi_wready_o, s_axi_arready_o} ==
          ~{\u_master.aw_q , \u_master.w_q , \u_master.ar_q })
  `ASSERT(HeldWriteAddress, s_axi_awready_o ||
          (\u_dut.u_flat.write_claim_q == write_claim && m_axi_awaddr_o == {Ports{awaddr_q[15:0]}}))
  `ASSERT(HeldWriteData, s_axi_wready_o ||
          (m_axi_wdata_o == {Ports{wdata_q}} && m_axi_wstrb_o == {Ports{wstrb_q}}))
  `ASSERT(HeldReadAddress, s_axi_arready_o ||
          (\u_dut.u_flat.read_claim_q == read_claim && m_axi_araddr_o == {Ports{araddr_q[15:0]}}))
  `ASSERT(BusyWrite, !write_busy || (!s_axi_awready_o && !s_axi_wready_o &&
          m_axi_bready_o == (s_axi_bvalid_o ? '0 : write_claim) && (s_axi_bvalid_o || write_claim != '0) &&
          aw_sent_q == (write_claim & ~m_axi_awvalid_o) && w_sent_q == (write_claim & ~m_axi_wvalid_o) &&
          b_back_q == (s_axi_bvalid_o ? write_claim : '0)))
  `ASSERT(BusyRead, !read_busy || (!s_axi_arready_o &&
          m_axi_rready_o == (s_axi_rvalid_o ? '0 : read_claim) && (s_axi_rvalid_o || read_claim != '0) &&
          ar_sent_q == (read_claim & ~m_axi_arvalid_o) && r_back_q == (s_axi_rvalid_o ? read_claim : '0)))
  `ASSERT(IdleWrite, write_busy || {s_axi_bvalid_o, m_axi_bready_o, aw_sent_q, w_sent_q, b_back_q, write_wait} == '0)
  `ASSERT(IdleRead, read_busy || {s_axi_rvalid_o, m_axi_rready_o, ar_sent_q, r_back_q, read_wait} == '0)
  `ASSERT(ValidOnlyWithReadyForTheResponse, ((m_axi_awvalid_o | m_axi_wvalid_o) & ~m_axi_bready_o) == '0 &&
          (m_axi_arvalid_o & ~m_axi_rready_o) == '0)
  `ASSERT(MasterWaitsForTheWrite, s_axi_awready_o || s_axi_wready_o || s_axi_bvalid_o ||
          \u_master.b_wait_q == (write_busy ? write_wait + 8'd1 : 8'd0))
  `ASSERT(MasterWaitsForTheRead, s_axi_arready_o || s_axi_rvalid_o ||
          \u_master.r_wait_q == (read_busy ? read_wait + 8'd1 : 8'd0))
  `REACH(WriteAndReadAtOnePort, (m_axi_awvalid_o & m_axi_arvalid_o) != '0)
  `REACH(WriteAndReadAtTwoPorts, m_axi_bready_o[0] && m_axi_rready_o[Ports-1])

endmodule

`default_nettype wire
