// Core of the encoder block: synchroniser, debounce, decoder, position, index latch, time stamps and error counters for
// up to six incremental encoders. It has no bus port. Axis i is bit i of every mask and element i of every array.
// Registers of axes that the block does not have read 0, and writes to them have no effect.
//
// A pin change reaches the position on the (debounce time + 3)rd clock edge: two edges for the synchroniser, `time` for
// the filter (0 counts as 1), one for the counter. All lines of all axes have the same delay, so clean edges keep their
// order. Bounce delays only the line that bounces. If the delayed edge comes after the next edge of the other line, the
// decoder reports an illegal transition or counts in the wrong direction.
//
// After reset the first stable levels are adopted without an event (see debounce): an encoder at rest with a high line
// causes no count, no illegal transition and no index.
`include "encoder_reg_types.svh"

module encoder_core #(
  parameter int                 Axes          = 6,  // 1..6
  parameter logic signed [31:0] PositionReset = 0  // initial position in counts, for tests of the wrap-around
) (
  input  logic            clk_i,
  input  logic            rst_ni,       // synchronous
  input  logic            clk_gated_i,  // of all flops but time and synchroniser
  output logic            active_o,     // clock request; 0: without an access no flop of clk_gated_i changes
  input  logic            trigger_i,    // one cycle per tick: snapshot of all axes

  input  logic [Axes-1:0] enc_a_i,      // asynchronous, all three; synchronised here
  input  logic [Axes-1:0] enc_b_i,
  input  logic [Axes-1:0] enc_z_i,

  /* verilator tracing_off */
  input  encoder_reg2hw_t reg2hw_i,
  output encoder_hw2reg_t hw2reg_o
  /* verilator tracing_on */
);

  localparam int MapAxes = 6;  // number of axes in the register map

  logic [31:0] now_q;     // cycles since reset
  logic [1:0]  filled_q;  // the synchroniser holds samples taken after reset

  always_ff @(posedge clk_i) begin
    if (!rst_ni) now_q <= '0;
    else         now_q <= now_q + 32'd1;
  end

  always_ff @(posedge clk_gated_i) begin
    if (!rst_ni) filled_q <= '0;
    else         filled_q <= {filled_q[0], 1'b1};
  end

  logic [3*Axes-1:0] synced, level, settled, glitch;
  logic              filter_idle;

  sync_2ff #(.Width(3*Axes)) u_sync (
    .clk_i,
    .rst_ni,
    .async_i({enc_z_i, enc_b_i, enc_a_i}),
    .level_o(synced)
  );

  debounce #(.Lines(3*Axes)) u_debounce (
    .clk_i   (clk_gated_i),
    .rst_ni,
    .mode_i  (reg2hw_i.filter_mode),
    .time_i  (reg2hw_i.debounce_time),
    .valid_i (filled_q[1]),
    .level_i (synced),
    .level_o (level),
    .known_o (settled),
    .glitch_o(glitch),
    .idle_o  (filter_idle)
  );

  // An edge of the index is also an edge of A or B, and their synchronisers may sample the two a clock apart. The index
  // is delayed by a clock, so that its position always includes the count of the edge.
  logic [Axes-1:0] a, b, z, z_q, z_rise, index_q, up, down;
  logic [Axes-1:0] known;                   // A and B have settled since reset: the axis counts
  logic [Axes-1:0] illegal_set, index_set;  // one cycle per event; index_set comes in the cycle after index_q
  assign {z, b, a} = level;
  assign z_rise    = z & ~z_q & settled[2*Axes +: Axes];
  assign known     = settled[0 +: Axes] & settled[Axes +: Axes];
  assign hw2reg_o.known_axes        = MapAxes'(known);
  assign hw2reg_o.fault_illegal_set = MapAxes'(illegal_set);
  assign hw2reg_o.fault_index_set   = MapAxes'(index_set);

  always_ff @(posedge clk_gated_i) begin
    if (!rst_ni) {z_q, index_q} <= '0;
    else         {z_q, index_q} <= {z, z_rise};
  end

  quad_decoder #(.Axes(Axes)) u_decoder (
    .clk_i    (clk_gated_i),
    .rst_ni,
    .a_i      (a),
    .b_i      (b),
    .known_i  (known),
    .up_o     (up),
    .down_o   (down),
    .illegal_o(illegal_set)
  );

  logic [Axes*32-1:0] position;                   // live
  logic [Axes*32-1:0] position_snaps, edge_times;  // before the clock edge of the last trigger
  assign hw2reg_o.position_value   = (MapAxes*32)'(position_snaps);
  assign hw2reg_o.edge_time_cycles = (MapAxes*32)'(edge_times);

  position_counters #(.Axes(Axes), .PositionReset(PositionReset)) u_position (
    .clk_i           (clk_gated_i),
    .rst_ni,
    .trigger_i,
    .now_i           (now_q),
    .up_i            (up),
    .down_i          (down),
    .position_o      (position),
    .position_snap_o (position_snaps),
    .edge_time_snap_o(edge_times),
    .trigger_time_o  (hw2reg_o.trigger_time_cycles)
  );

  // One signal per axis, only for waveforms.
  /* verilator lint_off UNUSEDSIGNAL */
  for (genvar i = 0; i < Axes; i++) begin : gen_axis
    logic [31:0] position_now, position_snap;
    assign position_now  = position[i*32 +: 32];
    assign position_snap = position_snaps[i*32 +: 32];
  end
  /* verilator lint_on UNUSEDSIGNAL */

  logic [Axes-1:0]    seen;
  logic [Axes*32-1:0] index_position;
  assign hw2reg_o.index_seen_axes      = MapAxes'(seen);
  assign hw2reg_o.index_position_value = (MapAxes*32)'(index_position);

  index_check #(.Axes(Axes)) u_index (
    .clk_i           (clk_gated_i),
    .rst_ni,
    .rise_i          (index_q),
    .position_i      (position),
    .up_i            (up),
    .down_i          (down),
    .check_i         (reg2hw_i.index_check_enable[Axes-1:0]),
    .first_i         (reg2hw_i.index_check_first[Axes-1:0]),
    .counts_per_rev_i(reg2hw_i.counts_per_rev_value[Axes*24-1:0]),
    .position_o      (index_position),
    .seen_o          (seen),
    .mismatch_o      (index_set)
  );

  logic [Axes*16-1:0] illegal_count, glitch_count;
  assign hw2reg_o.illegal_count_value = (MapAxes*16)'(illegal_count);
  assign hw2reg_o.glitch_count_value  = (MapAxes*16)'(glitch_count);

  error_counters #(.Axes(Axes)) u_error (
    .clk_i          (clk_gated_i),
    .rst_ni,
    .illegal_i      (illegal_set),
    .glitch_a_i     (glitch[0 +: Axes]),
    .glitch_b_i     (glitch[Axes +: Axes]),
    .glitch_z_i     (glitch[2*Axes +: Axes]),
    .illegal_count_o(illegal_count),
    .glitch_count_o (glitch_count)
  );

  event_time #(.Events(2)) u_fault_time (
    .clk_i  (clk_gated_i),
    .rst_ni,
    .now_i  (now_q),
    .event_i({index_set != '0, illegal_set != '0}),
    .flag_i ({reg2hw_i.fault_index[Axes-1:0] != '0, reg2hw_i.fault_illegal[Axes-1:0] != '0}),
    .time_o (hw2reg_o.fault_time_cycles)
  );

  // The decoder changes one clock after the filter accepts a level. An index edge can set a flag two clocks later.
  logic activity_q;
  assign active_o = synced != level || trigger_i || activity_q;

  always_ff @(posedge clk_gated_i) begin
    activity_q <= !rst_ni || synced != level || !filter_idle || z_rise != '0 || index_q != '0;
  end

  assign hw2reg_o.id_rdata = {encoder_reg_pkg::IdBlockReset, encoder_reg_pkg::IdVersionReset, 8'(Axes)};

  // Unused: the registers of axes that the block does not have, and the read strobe of a constant.
  logic unused;
  if (Axes < MapAxes) begin : gen_unused
    assign unused = ^{reg2hw_i.id_re, reg2hw_i.index_check_enable[MapAxes-1:Axes],
                      reg2hw_i.index_check_first[MapAxes-1:Axes],
                      reg2hw_i.counts_per_rev_value[MapAxes*24-1:Axes*24], reg2hw_i.fault_illegal[MapAxes-1:Axes],
                      reg2hw_i.fault_index[MapAxes-1:Axes]};
  end else begin : gen_unused
    assign unused = reg2hw_i.id_re;
  end

endmodule
