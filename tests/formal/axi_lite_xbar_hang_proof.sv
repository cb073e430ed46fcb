// The bus watchdog of axi_lite_xbar with the first three blocks of arm_soc. Each slave may stop accepting and answering
// at any time, in any order, come back late, and show responses that nobody asked for: it has no rules at all.
//
// Three ports stand for all: the crossbar handles the bits of its port vectors alike, and ports differ only in what
// they claim. That each request goes to the port that claims it, and the answer comes from there, is proved for all
// blocks (axi_lite_xbar_proof). What ports have in common are the requests in flight and `hung`: one port is in flight
// in a write, one in a read, and a third one is neither. With all blocks this proof takes 30 times the time.
//
// The master gets every response in a bounded time. It is the response that the port gave to this request within
// TimeoutClocks, or else SLVERR with zeros as data. A port is given up after exactly this time, or at once when it
// shows a response before it has accepted the request. Nothing new is sent to it until reset, and the other ports are
// not affected. So neither a late answer nor one that stays passes as that of a later request.
`include "assert.svh"
`default_nettype none

module axi_lite_xbar_hang_proof #(
  parameter int Ports = 3,
  parameter int TimeoutClocks = 2,
  parameter logic [Ports*32-1:0] Base = soc_map_pkg::XbarBase[Ports*32-1:0],
  parameter logic [Ports*32-1:0] Mask = soc_map_pkg::XbarMask[Ports*32-1:0]
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

  // The parts of a request that each slave has accepted and not answered. A response to less than that is no answer.
  logic [Ports-1:0] aw_q, w_q, ar_q, b_done, r_done, b_unasked, r_unasked;
  assign b_done    = m_axi_bvalid_i & m_axi_bready_o & (aw_q & w_q);
  assign r_done    = m_axi_rvalid_i & m_axi_rready_o & ar_q;
  assign b_unasked = m_axi_bvalid_i & m_axi_bready_o & ~(aw_q & w_q);
  assign r_unasked = m_axi_rvalid_i & m_axi_rready_o & ~ar_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) {aw_q, w_q, ar_q} <= '0;
    else begin
      aw_q <= (aw_q | (m_axi_awvalid_o & m_axi_awready_i)) & ~b_done;
      w_q  <= (w_q | (m_axi_wvalid_o & m_axi_wready_i)) & ~b_done;
      ar_q <= (ar_q | (m_axi_arvalid_o & m_axi_arready_i)) & ~r_done;
    end
  end

  // A port is given up when READY for its response falls without an answer.
  logic [Ports-1:0] b_unasked_q, r_unasked_q, bready_q, rready_q, b_q, r_q, given_up_q, write_ends, read_ends, given_up;
  assign write_ends = bready_q & ~m_axi_bready_o & ~b_q;
  assign read_ends  = rready_q & ~m_axi_rready_o & ~r_q;
  assign given_up   = given_up_q | write_ends | read_ends;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) {b_unasked_q, r_unasked_q, bready_q, rready_q, b_q, r_q, given_up_q} <= '0;
    else {b_unasked_q, r_unasked_q, bready_q, rready_q, b_q, r_q, given_up_q} <=
        {b_unasked, r_unasked, m_axi_bready_o, m_axi_rready_o, b_done, r_done, given_up};
  end

  // An answer has a legal code.
  logic [Ports-1:0] bad_code_b, bad_code_r;
  for (genvar i = 0; i < Ports; i++) begin : gen_code
    assign bad_code_b[i] = m_axi_bresp_i[2*i];
    assign bad_code_r[i] = m_axi_rresp_i[2*i];
  end
  `ASSUME(CodesAreLegal, (b_done & bad_code_b) == '0 && (r_done & bad_code_r) == '0)

  // The request in flight, and whether and what its port has answered.
  logic [31:0]      awaddr_q, araddr_q, rdata_q;
  logic [1:0]       bresp_q, rresp_q;
  logic [Ports-1:0] b_back_q, r_back_q, write_claim, read_claim;
  for (genvar i = 0; i < Ports; i++) begin : gen_claim
    assign write_claim[i] = (awaddr_q & Mask[i*32+:32]) == Base[i*32+:32];
    assign read_claim[i]  = (araddr_q & Mask[i*32+:32]) == Base[i*32+:32];
  end
  always_ff @(posedge clk_i) begin
    if (s_axi_awvalid_i && s_axi_awready_o) awaddr_q <= s_axi_awaddr_i;
    if (s_axi_arvalid_i && s_axi_arready_o) araddr_q <= s_axi_araddr_i;
    b_back_q <= (!rst_ni || (s_axi_bvalid_o && s_axi_bready_i)) ? '0 : b_back_q | b_done;
    r_back_q <= (!rst_ni || (s_axi_rvalid_o && s_axi_rready_i)) ? '0 : r_back_q | r_done;
    for (int i = 0; i < Ports; i++) begin
      if (b_done[i]) bresp_q <= m_axi_bresp_i[i*2+:2];
      if (r_done[i]) {rresp_q, rdata_q} <= {m_axi_rresp_i[i*2+:2], m_axi_rdata_i[i*32+:32]};
    end
  end

  localparam logic [1:0] SlvErr = 2'b10, DecErr = 2'b11;
  `ASSERT(AwOnlyToItsPort, (m_axi_awvalid_o & ~write_claim) == '0)
  `ASSERT(WOnlyToItsPort, (m_axi_wvalid_o & ~write_claim) == '0)
  `ASSERT(ArOnlyToItsPort, (m_axi_arvalid_o & ~read_claim) == '0)
  `ASSERT(BOnlyOfItsPort, (b_back_q & ~write_claim) == '0)
  `ASSERT(ROnlyOfItsPort, (r_back_q & ~read_claim) == '0)
  `ASSERT(BrespIsOfItsPortOrAnError, !s_axi_bvalid_o ||
          s_axi_bresp_o == (write_claim == '0 ? DecErr : b_back_q == '0 ? SlvErr : bresp_q))
  `ASSERT(RrespIsOfItsPortOrAnError, !s_axi_rvalid_o ||
          s_axi_rresp_o == (read_claim == '0 ? DecErr : r_back_q == '0 ? SlvErr : rresp_q))
  `ASSERT(RdataIsOfItsPortOrZero, !s_axi_rvalid_o || s_axi_rdata_o == (r_back_q == '0 ? 32'd0 : rdata_q))
  `ASSERT(NoNewWriteAfterATimeout, (m_axi_bready_o & ~bready_q & given_up_q) == '0)
  `ASSERT(NoNewReadAfterATimeout, (m_axi_rready_o & ~rready_q & given_up_q) == '0)
  `ASSERT(OtherPortsAnswerWrites, !s_axi_bvalid_o || b_back_q != '0 || (write_claim & ~given_up) == '0)
  `ASSERT(OtherPortsAnswerReads, !s_axi_rvalid_o || r_back_q != '0 || (read_claim & ~given_up) == '0)

  // Clocks before this one in which the crossbar has listened to the port.
  logic [7:0] write_time_q, read_time_q;
  always_ff @(posedge clk_i) begin
    write_time_q <= (!rst_ni || m_axi_bready_o == '0) ? '0 : write_time_q + 8'd1;
    read_time_q  <= (!rst_ni || m_axi_rready_o == '0) ? '0 : read_time_q + 8'd1;
  end
  `ASSERT(ListensForTheWholeTime, (write_ends == '0 || b_unasked_q != '0 || write_time_q == 8'(TimeoutClocks)) &&
          (read_ends == '0 || r_unasked_q != '0 || read_time_q == 8'(TimeoutClocks)))
  `ASSERT(UnaskedResponseGivesUp, (b_unasked_q & ~write_ends) == '0 && (r_unasked_q & ~read_ends) == '0)

  // Flops of u_dut and u_master, for the assertions that make the others inductive.
`include "axi_lite_xbar_flops.svh"
  (* hierconn *) wire [7:0]       \u_master.b_wait_q , \u_master.r_wait_q ;
  logic write_busy, read_busy;
  assign {write_busy, read_busy} = {\u_dut.u_flat.write_busy_q , \u_dut.u_flat.read_busy_q };
  `ASSERT(GivenUpIsHung, \u_dut.u_flat.hung == given_up)
  `ASSERT(WatchdogCountsTheTime, \u_dut.u_flat.write_wait_q == write_time_q &&
          \u_dut.u_flat.read_wait_q == read_time_q)
  `ASSERT(TimeIsBounded, (m_axi_bready_o == '0 || write_time_q < 8'(TimeoutClocks)) &&
          (m_axi_rready_o == '0 || read_time_q < 8'(TimeoutClocks)))
  `ASSERT(SlaveHasWhatItAccepted, (m_axi_bready_o & ((aw_q ^ ~m_axi_awvalid_o) | (w_q ^ ~m_axi_wvalid_o))) == '0 &&
          (m_axi_rready_o & (ar_q ^ ~m_axi_arvalid_o)) == '0)
  `ASSERT(IdleSlaveHasNothing, ((aw_q | w_q) & ~m_axi_bready_o & ~given_up) == '0 &&
          (ar_q & ~m_axi_rready_o & ~given_up) == '0)
  `ASSERT(ReadyFallsWhileARequestIsHeld, {s_axi_awready_o, s_axi_wready_o, s_axi_arready_o} ==
          ~{\u_master.aw_q , \u_master.w_q , \u_master.ar_q })
  `ASSERT(HeldAddresses, (s_axi_awready_o || \u_dut.u_flat.write_claim_q == write_claim) &&
          (s_axi_arready_o || \u_dut.u_flat.read_claim_q == read_claim))
  `ASSERT(BusyWrite, !write_busy || (!s_axi_awready_o && !s_axi_wready_o &&
          m_axi_bready_o == (s_axi_bvalid_o ? '0 : write_claim) && (s_axi_bvalid_o || write_claim != '0) &&
          (b_back_q == '0 || (s_axi_bvalid_o && b_back_q == write_claim))))
  `ASSERT(BusyRead, !read_busy || (!s_axi_arready_o &&
          m_axi_rready_o == (s_axi_rvalid_o ? '0 : read_claim) && (s_axi_rvalid_o || read_claim != '0) &&
          (r_back_q == '0 || (s_axi_rvalid_o && r_back_q == read_claim))))
  `ASSERT(IdleWrite, write_busy || {s_axi_bvalid_o, m_axi_bready_o, b_back_q, write_time_q} == '0)
  `ASSERT(IdleRead, read_busy || {s_axi_rvalid_o, m_axi_rready_o, r_back_q, read_time_q} == '0)
  `ASSERT(ValidOnlyWithReadyForTheResponse, ((m_axi_awvalid_o | m_axi_wvalid_o) & ~m_axi_bready_o) == '0 &&
          (m_axi_arvalid_o & ~m_axi_rready_o) == '0)
  `ASSERT(MasterWaitsForTheWrite, s_axi_awready_o || s_axi_wready_o || s_axi_bvalid_o ||
          \u_master.b_wait_q == (write_busy ? write_time_q + 8'd1 : 8'd0))
  `ASSERT(MasterWaitsForTheRead, s_axi_arready_o || s_axi_rvalid_o ||
          \u_master.r_wait_q == (read_busy ? read_time_q + 8'd1 : 8'd0))

  `REACH(LastPortIsHungLast, given_up_q == {1'b0, {Ports-1{1'b1}}} && given_up[Ports-1])
  `REACH(OnePortIsLeft, given_up_q == {{Ports-1{1'b1}}, 1'b0} && s_axi_rvalid_o && read_claim[0] &&
         s_axi_rresp_o == 2'b00)
  `REACH(HungPortIsRefused, given_up_q[0] && given_up_q[1] && s_axi_rvalid_o && read_claim[0] && read_time_q == '0 &&
         !rready_q[0])
  `REACH(LateAnswer, given_up_q[0] && m_axi_rvalid_i[0] && ar_q[0] && !m_axi_rready_o[0])
  `REACH(AnswerThatStaysIsRefused, r_unasked_q[0] && r_back_q == '0 && s_axi_rvalid_o && rdata_q != '0 && ar_q == '0)
  `REACH(WriteInFlightAtAPortThatAReadGivesUp, given_up_q[0] && b_done[0] && m_axi_bresp_i[1:0] == 2'b00)

endmodule

`default_nettype wire
