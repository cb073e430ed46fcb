// Position and time of the last count of `Axes` encoders, and the snapshot of both at the trigger.
//
// Axis i is element i of every vector. A new vector is built completely and assigned once, only in cycles with an
// event. In other cycles the simulator copies nothing.
module position_counters #(
  parameter int                 Axes          = 6,
  parameter logic signed [31:0] PositionReset = 0
) (
  input  logic               clk_i,
  input  logic               rst_ni,          // synchronous
  input  logic               trigger_i,       // one cycle: snapshot of the state before this clock edge
  input  logic [31:0]        now_i,           // cycles
  input  logic [Axes-1:0]    up_i,            // one cycle per count; up_i and down_i of an axis are never both 1
  input  logic [Axes-1:0]    down_i,
  output logic [Axes*32-1:0] position_o,      // counts, present value, wraps
  // Snapshots of the last trigger.
  output logic [Axes*32-1:0] position_snap_o,  // counts
  output logic [Axes*32-1:0] edge_time_snap_o,  // cycles: time of the last count
  output logic [31:0]        trigger_time_o   // cycles: time of the trigger
);

  logic [Axes*32-1:0] edge_time_q;  // cycles

  // Temporaries of the clocked process, written before they are read.
  logic [Axes*32-1:0] position, edge_time;

  /* verilator lint_off BLKSEQ */
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      position_o  <= {Axes{PositionReset}};
      edge_time_q <= '0;
    end else if ((up_i | down_i) != '0) begin
      position  = position_o;
      edge_time = edge_time_q;
      for (int i = 0; i < Axes; i++) begin
        if (up_i[i] || down_i[i]) begin
          position[i*32 +: 32]  = position[i*32 +: 32] + (up_i[i] ? 32'd1 : -32'd1);
          edge_time[i*32 +: 32] = now_i;
        end
      end
      position_o  <= position;
      edge_time_q <= edge_time;
    end
  end
  /* verilator lint_on BLKSEQ */

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      position_snap_o  <= {Axes{PositionReset}};
      edge_time_snap_o <= '0;
      trigger_time_o   <= '0;
    end else if (trigger_i) begin
      position_snap_o  <= position_o;
      edge_time_snap_o <= edge_time_q;
      trigger_time_o   <= now_i;
    end
  end

endmodule
