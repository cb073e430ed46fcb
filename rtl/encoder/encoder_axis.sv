// Counters of one encoder axis: position, time of the last count, illegal transitions and glitches, with the snapshot
// of the trigger. Everything comes as one-cycle events from the decoder and the filter.
module encoder_axis #(
  parameter logic signed [31:0] PositionReset = 0
) (
  input  logic        clk_i,
  input  logic        rst_ni,           // synchronous
  input  logic        trigger_i,        // one cycle: snapshot of the state before this clock edge
  input  logic [31:0] now_i,            // cycles
  input  logic        up_i,
  input  logic        down_i,
  input  logic        illegal_i,
  input  logic        error_i,          // illegal_i or a glitch: guards the error counters
  input  logic        glitch_a_i,
  input  logic        glitch_b_i,
  input  logic        glitch_z_i,
  output logic [31:0] position_o,       // counts, live
  output logic [31:0] position_snap_o,
  output logic [31:0] edge_time_snap_o, // cycles
  output logic [15:0] illegal_count_o,  // saturating
  output logic [15:0] glitch_count_o    // saturating
);

  logic [31:0] edge_time_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      position_snap_o  <= PositionReset;
      edge_time_snap_o <= '0;
      position_o       <= PositionReset;
      edge_time_q      <= '0;
    end else begin
      if (trigger_i) begin
        position_snap_o  <= position_o;
        edge_time_snap_o <= edge_time_q;
      end
      if (up_i || down_i) begin
        position_o  <= position_o + (up_i ? 32'd1 : -32'd1);
        edge_time_q <= now_i;
      end
    end
  end

  // A function, so that a simulator evaluates it in the cycle of an error only.
  function automatic logic [15:0] sum_of(input logic a, input logic b, input logic z);
    sum_of = 16'(a) + 16'(b) + 16'(z);
  endfunction

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      illegal_count_o <= '0;
      glitch_count_o  <= '0;
    end else if (error_i) begin
      if (illegal_i && illegal_count_o != '1) illegal_count_o <= illegal_count_o + 16'd1;
      if (sum_of(glitch_a_i, glitch_b_i, glitch_z_i) > ~glitch_count_o) glitch_count_o <= '1;
      else glitch_count_o <= glitch_count_o + sum_of(glitch_a_i, glitch_b_i, glitch_z_i);
    end
  end

endmodule
