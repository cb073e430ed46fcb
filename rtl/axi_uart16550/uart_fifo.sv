// FIFO of a UART: 16 entries, or a single entry that a push overwrites (the holding register of a 16450).
//
// Push and pop are allowed in the same clock at any level. flush_i wins over both. single_i may change only together
// with flush_i.
`include "assert.svh"

module uart_fifo #(
  parameter int Width = 8
) (
  input  logic             clk_i,
  input  logic             rst_ni,      // synchronous; empties the FIFO
  input  logic             awake_i,     // clock enable: 0 holds every flop
  input  logic             single_i,    // 1: depth 1, a push overwrites; 0: 16 entries
  input  logic             flush_i,     // one clock: empties the FIFO
  input  logic             push_i,      // one clock: stores data_i
  input  logic [Width-1:0] data_i,
  input  logic             pop_i,       // ignored while empty
  output logic [Width-1:0] top_o,       // oldest entry, valid while level_o is not 0
  output logic [4:0]       level_o,     // number of entries
  output logic             fresh_o,     // the last clock edge brought a new entry to top_o
  output logic             overrun_o,   // push_i while full: the new entry (16) or the old one (single) is lost
  output logic             empties_o    // the coming clock edge empties the FIFO
);

  localparam int Depth = 16;

  logic [Width-1:0] entry_q [Depth];
  logic [3:0]       read_q, write_q;

  logic pops, full, stores, replaces;
  always_comb begin
    pops      = 1'b0;
    full      = 1'b0;
    overrun_o = 1'b0;
    replaces  = 1'b0;
    stores    = 1'b0;
    empties_o = 1'b0;
    if (awake_i) begin
      pops      = pop_i && level_o != '0;
      full      = single_i ? level_o != '0 : level_o == 5'(Depth);
      overrun_o = push_i && full && !pops;
      replaces  = overrun_o && single_i;
      stores    = push_i && !overrun_o;
      empties_o = level_o != '0 && (flush_i || (pops && level_o == 5'd1 && !push_i));
    end
  end
  assign top_o     = awake_i ? entry_q[read_q] : '0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {read_q, write_q} <= '0;
      level_o           <= '0;
      fresh_o           <= 1'b0;
    end else if (awake_i) begin
      if (flush_i) begin
        {read_q, write_q} <= '0;
        level_o           <= '0;
        fresh_o           <= 1'b0;
      end else if (push_i || pop_i || fresh_o) begin
        if (stores) write_q <= write_q + 4'd1;
        if (pops)   read_q  <= read_q + 4'd1;
        if (stores != pops) level_o <= stores ? level_o + 5'd1 : level_o - 5'd1;
        fresh_o <= replaces || (pops ? level_o != 5'd1 || push_i : stores && level_o == '0);
      end
    end
  end

  // Memory, not reset.
  always_ff @(posedge clk_i) begin
    if (awake_i && (stores || replaces)) entry_q[replaces ? read_q : write_q] <= data_i;
  end

`ifdef ASSERT_ON
  logic ran_q, single_q, flush_q;
  always_ff @(posedge clk_i) begin
    ran_q    <= rst_ni;
    single_q <= single_i;
    flush_q  <= flush_i;
  end
`endif

  `ASSERT(HoldsNoMoreThanItsDepth, level_o <= (single_i ? 5'd1 : 5'(Depth)))
  `ASSERT(PointersAgreeWithTheLevel, write_q - read_q == level_o[3:0])
  `ASSERT(FreshOnlyWithAnEntry, !fresh_o || level_o != '0)
  `ASSERT(DepthChangesOnlyWithAFlush, !ran_q || single_i == single_q || flush_q)

  `COVER(OverrunOfAFullFifo, overrun_o && !single_i)
  `COVER(OverrunOfOneEntry, overrun_o && single_i)
  `COVER(PopMakesRoomForAPush, push_i && pops && full)
  `COVER(FlushOfEntries, flush_i && level_o != '0)

endmodule
