// The rules of one AXI4-Lite port in this project: each direction has one transaction in flight.
//
// The module has no outputs. `AssumeMaster` and `AssumeSlave` select the side that is the environment. Its rules are
// assumed; the rules of the other side are proved. A master may keep VALID high during reset and may delay the address
// or the data of a write without limit. BREADY and RREADY are free.
//
// A bound counts only the clocks in which this side alone delays the transaction. It is therefore independent of the
// other direction and of the other channel of a write: there is no deadlock.
`include "assert.svh"
`default_nettype none

module axi_lite_properties #(
  parameter int AddrWidth    = 16,
  parameter bit AssumeMaster = 1'b1,
  parameter bit AssumeSlave  = 1'b0,
  parameter int MaxReady     = 0,     // maximum clocks from VALID, with nothing in flight on its channel, to READY
  parameter int MaxResponse  = 2,     // maximum clocks from the acceptance of the whole request to BVALID or RVALID
  parameter bit MayDecErr    = 1'b0,  // a DECERR is legal and must be reachable
  parameter bit MayStall     = 1'b1   // the master can stall responses, which must be reachable
) (
  input wire                 clk_i,
  input wire                 rst_ni,
  input wire [AddrWidth-1:0] awaddr,
  input wire                 awvalid,
  input wire                 awready,
  input wire [31:0]          wdata,
  input wire [3:0]           wstrb,
  input wire                 wvalid,
  input wire                 wready,
  input wire [1:0]           bresp,
  input wire                 bvalid,
  input wire                 bready,
  input wire [AddrWidth-1:0] araddr,
  input wire                 arvalid,
  input wire                 arready,
  input wire [31:0]          rdata,
  input wire [1:0]           rresp,
  input wire                 rvalid,
  input wire                 rready
);

  localparam logic [1:0] Okay = 2'b00, ExOkay = 2'b01, SlvErr = 2'b10, DecErr = 2'b11;

  logic aw_done, w_done, b_done, ar_done, r_done;
  assign aw_done = awvalid && awready;
  assign w_done  = wvalid && wready;
  assign b_done  = bvalid && bready;
  assign ar_done = arvalid && arready;
  assign r_done  = rvalid && rready;

  // Parts of requests that were accepted in an earlier clock and have no response yet.
  logic aw_q, w_q, ar_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {aw_q, w_q, ar_q} <= '0;
    end else begin
      if (aw_done) aw_q <= 1'b1;
      else if (b_done) aw_q <= 1'b0;
      if (w_done) w_q <= 1'b1;
      else if (b_done) w_q <= 1'b0;
      if (ar_done) ar_q <= 1'b1;
      else if (r_done) ar_q <= 1'b0;
    end
  end

  // The previous clock: payload with VALID but without READY.
  logic                 reset_q = 1'b0;
  logic                 aw_held_q, w_held_q, b_held_q, ar_held_q, r_held_q;
  logic [AddrWidth-1:0] awaddr_q, araddr_q;
  logic [31:0]          wdata_q, rdata_q;
  logic [3:0]           wstrb_q;
  logic [1:0]           bresp_q, rresp_q;
  always_ff @(posedge clk_i) begin
    reset_q   <= !rst_ni;
    aw_held_q <= rst_ni && awvalid && !awready;
    w_held_q  <= rst_ni && wvalid && !wready;
    b_held_q  <= rst_ni && bvalid && !bready;
    ar_held_q <= rst_ni && arvalid && !arready;
    r_held_q  <= rst_ni && rvalid && !rready;
    awaddr_q  <= awaddr;
    wdata_q   <= wdata;
    wstrb_q   <= wstrb;
    bresp_q   <= bresp;
    araddr_q  <= araddr;
    rdata_q   <= rdata;
    rresp_q   <= rresp;
  end

  // Master.
  formal_rule #(.Assume(AssumeMaster)) AwStaysUntilReady (rst_ni, !aw_held_q || (awvalid && awaddr == awaddr_q));
  formal_rule #(.Assume(AssumeMaster)) WStaysUntilReady
    (rst_ni, !w_held_q || (wvalid && wdata == wdata_q && wstrb == wstrb_q));
  formal_rule #(.Assume(AssumeMaster)) ArStaysUntilReady (rst_ni, !ar_held_q || (arvalid && araddr == araddr_q));
  if (!AssumeMaster) begin : gen_master
    formal_rule AsksNothingAfterReset (reset_q, !awvalid && !wvalid && !arvalid);
  end

  // Slave: responses.
  formal_rule #(.Assume(AssumeSlave)) AnswersNothingAfterReset (reset_q, !bvalid && !rvalid);
  formal_rule #(.Assume(AssumeSlave)) BStaysUntilReady (rst_ni, !b_held_q || (bvalid && bresp == bresp_q));
  formal_rule #(.Assume(AssumeSlave)) RStaysUntilReady
    (rst_ni, !r_held_q || (rvalid && rdata == rdata_q && rresp == rresp_q));
  formal_rule #(.Assume(AssumeSlave)) BAnswersAWholeWrite (rst_ni, !bvalid || (aw_q && w_q));
  formal_rule #(.Assume(AssumeSlave)) RAnswersARead (rst_ni, !rvalid || ar_q);
  formal_rule #(.Assume(AssumeSlave)) BrespIsLegal
    (rst_ni, !bvalid || (bresp != ExOkay && (MayDecErr || bresp != DecErr)));
  formal_rule #(.Assume(AssumeSlave)) RrespIsLegal
    (rst_ni, !rvalid || (rresp != ExOkay && (MayDecErr || rresp != DecErr)));

  // Slave: requests.
  formal_rule #(.Assume(AssumeSlave)) OneAwInFlight (rst_ni, !(aw_done && aw_q));
  formal_rule #(.Assume(AssumeSlave)) OneWInFlight (rst_ni, !(w_done && w_q));
  formal_rule #(.Assume(AssumeSlave)) OneArInFlight (rst_ni, !(ar_done && ar_q));

  // Number of clocks waited, including this one; saturates at the bound.
  logic [7:0] aw_wait_q, w_wait_q, ar_wait_q, b_wait_q, r_wait_q;
  logic       aw_waits, w_waits, ar_waits, b_waits, r_waits;
  assign aw_waits = awvalid && !awready && !aw_q;
  assign w_waits  = wvalid && !wready && !w_q;
  assign ar_waits = arvalid && !arready && !ar_q;
  assign b_waits  = aw_q && w_q && !bvalid;
  assign r_waits  = ar_q && !rvalid;
  always_ff @(posedge clk_i) begin
    aw_wait_q <= !(rst_ni && aw_waits) ? 8'd0 : (aw_wait_q == 8'(MaxReady)) ? aw_wait_q : aw_wait_q + 8'd1;
    w_wait_q  <= !(rst_ni && w_waits) ? 8'd0 : (w_wait_q == 8'(MaxReady)) ? w_wait_q : w_wait_q + 8'd1;
    ar_wait_q <= !(rst_ni && ar_waits) ? 8'd0 : (ar_wait_q == 8'(MaxReady)) ? ar_wait_q : ar_wait_q + 8'd1;
    b_wait_q  <= !(rst_ni && b_waits) ? 8'd0 : (b_wait_q == 8'(MaxResponse)) ? b_wait_q : b_wait_q + 8'd1;
    r_wait_q  <= !(rst_ni && r_waits) ? 8'd0 : (r_wait_q == 8'(MaxResponse)) ? r_wait_q : r_wait_q + 8'd1;
  end
  formal_rule #(.Assume(AssumeSlave)) TakesAwInTime (rst_ni, !aw_waits || aw_wait_q < 8'(MaxReady));
  formal_rule #(.Assume(AssumeSlave)) TakesWInTime (rst_ni, !w_waits || w_wait_q < 8'(MaxReady));
  formal_rule #(.Assume(AssumeSlave)) TakesArInTime (rst_ni, !ar_waits || ar_wait_q < 8'(MaxReady));
  formal_rule #(.Assume(AssumeSlave)) AnswersWritesInTime (rst_ni, !b_waits || b_wait_q < 8'(MaxResponse));
  formal_rule #(.Assume(AssumeSlave)) AnswersReadsInTime (rst_ni, !r_waits || r_wait_q < 8'(MaxResponse));

  // Cases that must be reachable, or the rules above would be vacuous.
  logic written_q, read_q;  // a whole transaction has been completed
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {written_q, read_q} <= '0;
    end else begin
      if (b_done) written_q <= 1'b1;
      if (r_done) read_q <= 1'b1;
    end
  end
  `REACH(AwBeforeW, w_done && aw_q)
  `REACH(WBeforeAw, aw_done && w_q)
  `REACH(AwWithW, aw_done && w_done)
  `REACH(WriteOkay, b_done && bresp == Okay)
  `REACH(ReadOkay, r_done && rresp == Okay)
  `REACH(SecondWrite, written_q && b_done)
  `REACH(SecondRead, read_q && r_done)
  `REACH(WriteSlvErr, b_done && bresp == SlvErr)
  `REACH(ReadSlvErr, r_done && rresp == SlvErr)
  if (MayStall) begin : gen_stall
    `REACH(BothAnswersStall, b_held_q && r_held_q)
  end
  if (MayDecErr) begin : gen_decerr
    `REACH(WriteDecErr, b_done && bresp == DecErr)
    `REACH(ReadDecErr, r_done && rresp == DecErr)
  end

endmodule

`default_nettype wire
