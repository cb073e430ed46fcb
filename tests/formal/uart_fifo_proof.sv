// uart_fifo against the rules of a queue: number of entries, order, losses, and the reports about its oldest entry.
//
// The order is proved with one marked entry, which may be any entry ever stored: it keeps its data, moves up with every
// read, and comes out when all older entries are gone. The data have two bits, because entries are only copied.
`include "assert.svh"
`default_nettype none

module uart_fifo_proof (
  input wire       clk_i,
  input wire       rst_ni,
  input wire       awake_i,
  input wire       single_i,
  input wire       flush_i,
  input wire       push_i,
  input wire [1:0] data_i,
  input wire       pop_i,
  input wire       mark_i  // marks the entry that is stored in this clock
);

  logic [1:0] top_o;
  logic [4:0] level_o;
  logic       fresh_o, overrun_o, empties_o;
  uart_fifo #(.Width(2)) u_dut (.*);

  `RESET_FIRST

  logic after_q = 1'b0;
  logic single_q, flush_q;
  always_ff @(posedge clk_i) begin
    after_q  <= rst_ni;
    single_q <= single_i;
    flush_q  <= flush_i;
  end
  `ASSUME(DepthChangesWithAFlush, !after_q || single_i == single_q || flush_q)
  `ASSUME(AFlushIsAwake, !flush_i || awake_i)

  // A queue of 16 entries, or of one that a push replaces.
  logic [4:0] count_q, depth, rest;
  logic       pops, lost, replaces, stores, fresh_q;
  assign depth    = single_i ? 5'd1 : 5'd16;
  assign pops     = awake_i && pop_i && count_q != '0;
  assign rest     = count_q - 5'(pops);  // entries that stay
  assign lost     = awake_i && push_i && rest == depth;
  assign replaces = lost && single_i;
  assign stores   = awake_i && push_i && !lost;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || flush_i) count_q <= '0;
    else count_q <= rest + 5'(stores);

    // A new oldest entry: the next one after a read, the first one of an empty queue, or a replaced one.
    if (!rst_ni || flush_i) fresh_q <= 1'b0;
    else if (awake_i) fresh_q <= (pops && rest + 5'(stores) != '0) || (stores && count_q == '0) || replaces;
  end

  `ASSERT(LevelIsTheNumberOfEntries, level_o == count_q)
  `ASSERT(NeverFullerThanItsDepth, count_q <= depth)
  `ASSERT(ReportsEachLoss, overrun_o == lost)
  `ASSERT(ReportsEachNewOldestEntry, fresh_o == fresh_q)
  `ASSERT(ReportsThatItEmpties, empties_o == (awake_i && count_q != '0 && (flush_i || (rest == '0 && !push_i))))

  // The marked entry: older_q entries are in front of it.
  logic       marked_q;
  logic [3:0] older_q;
  logic [1:0] data_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || flush_i) marked_q <= 1'b0;
    else if (marked_q ? (pops && older_q == '0) || replaces : mark_i && (stores || replaces)) begin
      marked_q <= mark_i && (replaces || (stores && !marked_q));
      older_q  <= replaces ? '0 : 4'(rest);
      data_q   <= data_i;
    end else if (pops) older_q <= older_q - 4'd1;
  end
  `ASSERT(TheMarkedEntryComesOutInItsTurn, !(awake_i && marked_q && older_q == '0) || top_o == data_q)
  `ASSERT(TheMarkedEntryStaysInside, !marked_q || {1'b0, older_q} < count_q)

  // The memory: `flatten` connects these nets to its words of the same names.
  (* hierconn *) wire [3:0] \u_dut.read_q ;
  (* hierconn *) wire [1:0] \u_dut.entry_q[0] , \u_dut.entry_q[1] , \u_dut.entry_q[2] , \u_dut.entry_q[3] ;
  (* hierconn *) wire [1:0] \u_dut.entry_q[4] , \u_dut.entry_q[5] , \u_dut.entry_q[6] , \u_dut.entry_q[7] ;
  (* hierconn *) wire [1:0] \u_dut.entry_q[8] , \u_dut.entry_q[9] , \u_dut.entry_q[10] , \u_dut.entry_q[11] ;
  (* hierconn *) wire [1:0] \u_dut.entry_q[12] , \u_dut.entry_q[13] , \u_dut.entry_q[14] , \u_dut.entry_q[15] ;
  logic [1:0] entry [16];
  assign entry[0] = \u_dut.entry_q[0] ; assign entry[1] = \u_dut.entry_q[1] ;
  assign entry[2] = \u_dut.entry_q[2] ; assign entry[3] = \u_dut.entry_q[3] ;
  assign entry[4] = \u_dut.entry_q[4] ; assign entry[5] = \u_dut.entry_q[5] ;
  assign entry[6] = \u_dut.entry_q[6] ; assign entry[7] = \u_dut.entry_q[7] ;
  assign entry[8] = \u_dut.entry_q[8] ; assign entry[9] = \u_dut.entry_q[9] ;
  assign entry[10] = \u_dut.entry_q[10] ; assign entry[11] = \u_dut.entry_q[11] ;
  assign entry[12] = \u_dut.entry_q[12] ; assign entry[13] = \u_dut.entry_q[13] ;
  assign entry[14] = \u_dut.entry_q[14] ; assign entry[15] = \u_dut.entry_q[15] ;
  logic [3:0] place;
  assign place = \u_dut.read_q + older_q;
  for (genvar i = 0; i < 16; i++) begin : gen_entry
    `ASSERT(TheMarkedEntryKeepsItsData, !(marked_q && place == 4'(i)) || entry[i] == data_q)
  end
  `REACH(Full, level_o == 5'd16 && !single_i)
  `REACH(PushMeetsPopOfTheLast, pops && push_i && count_q == 5'd1 && marked_q)
  `REACH(ReplacesTheMarked, replaces && marked_q)

endmodule

`default_nettype wire
