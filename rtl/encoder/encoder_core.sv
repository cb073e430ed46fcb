// Six incremental encoders: synchroniser, debounce, decoder, position, index latch, time stamps and error counters. It
// never sees the bus; ports are named as the registers they serve. Axis i is bit i and element i of everything.
//
// A pin change reaches the position on the (debounce time + 3)rd clock edge: two edges for the synchroniser, `time` for
// the filter (0 counts as 1), one for the counter. All lines of all axes take the same path, so clean edges keep their
// order; chatter delays its own line only. A step that the filter thereby shifts past the next one of the other line
// comes out as an illegal transition or as a wrong direction.
//
// After reset the levels that the filter first finds stable are adopted silently (see debounce): an encoder that rests
// with a line high makes no count, no illegal transition and no index.
module encoder_core #(
  parameter int                 Axes          = 6,
  parameter logic signed [31:0] PositionReset = 0  // start value of the positions, for tests of their wrap
) (
  input  logic               clk_i,
  input  logic               rst_ni,            // synchronous
  input  logic               trigger_i,         // one cycle per tick: snapshot of all axes

  input  logic [Axes-1:0]    enc_a_i,           // asynchronous
  input  logic [Axes-1:0]    enc_b_i,
  input  logic [Axes-1:0]    enc_z_i,

  input  logic [7:0]         debounce_time_i,   // cycles
  input  logic               filter_mode_i,     // of the debounce: 0 restart, 1 up/down
  input  logic [Axes-1:0]    index_check_i,     // check enabled
  input  logic [Axes*24-1:0] counts_per_rev_i,

  // Snapshot of the last trigger: the state before that clock edge.
  output logic [Axes*32-1:0] position_o,        // counts, signed, wraps
  output logic [Axes*32-1:0] edge_time_o,       // cycles, of the last count
  output logic [31:0]        trigger_time_o,    // cycles, of the trigger

  // Live.
  output logic [Axes-1:0]    known_o,           // A and B have settled since reset: the axis counts
  output logic [Axes*32-1:0] index_position_o,  // counts, at the last rising edge of Z
  output logic [Axes-1:0]    index_seen_o,      // index_position_o is valid
  output logic [Axes*16-1:0] illegal_count_o,   // saturating
  output logic [Axes*16-1:0] glitch_count_o,    // A, B and Z together, saturating

  output logic [Axes-1:0]    illegal_set_o,     // one cycle per event
  output logic [Axes-1:0]    index_set_o,       // one cycle per event, in the cycle after the index edge
  input  logic [Axes-1:0]    illegal_i,         // the sticky flags
  input  logic [Axes-1:0]    index_i,
  output logic [2*32-1:0]    fault_time_o       // of the first event of a group: 0 illegal, 1 index
);

  logic [31:0] now_q;     // cycles since reset
  logic [1:0]  filled_q;  // the synchroniser carries samples taken after reset

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      now_q    <= '0;
      filled_q <= '0;
    end else begin
      now_q    <= now_q + 32'd1;
      filled_q <= {filled_q[0], 1'b1};
    end
  end

  logic [3*Axes-1:0] synced, level, known, glitch;

  sync_2ff #(.Width(3*Axes)) u_sync (
    .clk_i,
    .rst_ni,
    .async_i({enc_z_i, enc_b_i, enc_a_i}),
    .level_o(synced)
  );

  debounce #(.Lines(3*Axes)) u_debounce (
    .clk_i,
    .rst_ni,
    .mode_i  (filter_mode_i),
    .time_i  (debounce_time_i),
    .valid_i (filled_q[1]),
    .level_i (synced),
    .level_o (level),
    .known_o (known),
    .glitch_o(glitch)
  );

  logic [Axes-1:0] a, b, z, z_q, z_rise, up, down;
  assign {z, b, a} = level;
  assign z_rise    = z & ~z_q & known[2*Axes +: Axes];
  assign known_o   = known[0 +: Axes] & known[Axes +: Axes];

  always_ff @(posedge clk_i) begin
    if (!rst_ni) z_q <= '0;
    else z_q <= z;
  end

  quad_decoder #(.Axes(Axes)) u_decoder (
    .clk_i,
    .rst_ni,
    .a_i      (a),
    .b_i      (b),
    .known_i  (known_o),
    .up_o     (up),
    .down_o   (down),
    .illegal_o(illegal_set_o)
  );

  logic [Axes*32-1:0] position;  // live

  position_counters #(.Axes(Axes), .PositionReset(PositionReset)) u_position (
    .clk_i,
    .rst_ni,
    .trigger_i,
    .now_i           (now_q),
    .up_i            (up),
    .down_i          (down),
    .position_o      (position),
    .position_snap_o (position_o),
    .edge_time_snap_o(edge_time_o),
    .trigger_time_o
  );

  // One signal per axis, for waveforms only.
  /* verilator lint_off UNUSEDSIGNAL */
  for (genvar i = 0; i < Axes; i++) begin : gen_axis
    logic [31:0] position_now, position_snap;
    assign position_now  = position[i*32 +: 32];
    assign position_snap = position_o[i*32 +: 32];
  end
  /* verilator lint_on UNUSEDSIGNAL */

  index_check #(.Axes(Axes)) u_index (
    .clk_i,
    .rst_ni,
    .rise_i          (z_rise),
    .position_i      (position),
    .up_i            (up),
    .down_i          (down),
    .check_i         (index_check_i),
    .counts_per_rev_i,
    .position_o      (index_position_o),
    .seen_o          (index_seen_o),
    .mismatch_o      (index_set_o)
  );

  error_counters #(.Axes(Axes)) u_error (
    .clk_i,
    .rst_ni,
    .illegal_i (illegal_set_o),
    .glitch_a_i(glitch[0 +: Axes]),
    .glitch_b_i(glitch[Axes +: Axes]),
    .glitch_z_i(glitch[2*Axes +: Axes]),
    .illegal_count_o,
    .glitch_count_o
  );

  event_time #(.Events(2)) u_fault_time (
    .clk_i,
    .rst_ni,
    .now_i  (now_q),
    .event_i({index_set_o != '0, illegal_set_o != '0}),
    .flag_i ({index_i != '0, illegal_i != '0}),
    .time_o (fault_time_o)
  );

endmodule
