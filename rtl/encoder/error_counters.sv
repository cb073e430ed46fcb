// Saturating counters for the illegal transitions and the glitches of `Axes` encoders. Axis i is element i.
`include "assert.svh"

module error_counters #(
  parameter int Axes = 6
) (
  input  logic               clk_i,
  input  logic               rst_ni,           // synchronous
  input  logic [Axes-1:0]    illegal_i,        // one cycle per event
  input  logic [Axes-1:0]    glitch_a_i,
  input  logic [Axes-1:0]    glitch_b_i,
  input  logic [Axes-1:0]    glitch_z_i,
  output logic [Axes*16-1:0] illegal_count_o,  // 16 bits per axis, saturating
  output logic [Axes*16-1:0] glitch_count_o    // sum over A, B and Z
);

  // Temporaries of the clocked process, written before they are read.
  logic [Axes*16-1:0] illegal, glitches;
  logic [15:0]        more;

  /* verilator lint_off BLKSEQ */
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      illegal_count_o <= '0;
      glitch_count_o  <= '0;
    end else if ((illegal_i | glitch_a_i | glitch_b_i | glitch_z_i) != '0) begin
      illegal  = illegal_count_o;
      glitches = glitch_count_o;
      for (int i = 0; i < Axes; i++) begin
        if (illegal_i[i] && illegal[i*16 +: 16] != '1) illegal[i*16 +: 16] = illegal[i*16 +: 16] + 16'd1;
        more = 16'(glitch_a_i[i]) + 16'(glitch_b_i[i]) + 16'(glitch_z_i[i]);
        if (more > ~glitches[i*16 +: 16]) glitches[i*16 +: 16] = '1;
        else glitches[i*16 +: 16] = glitches[i*16 +: 16] + more;
      end
      illegal_count_o <= illegal;
      glitch_count_o  <= glitches;
    end
  end
  /* verilator lint_on BLKSEQ */

  `COVER(IllegalCounterIsFull, illegal_i[0] && illegal_count_o[15:0] == '1)
  `COVER(GlitchCounterIsFull, glitch_a_i[0] && glitch_count_o[15:0] == '1)
  `COVER(ThreeGlitchesAtOnce, (glitch_a_i & glitch_b_i & glitch_z_i) != '0)

endmodule
