// One axis of Vo's pulse generator (Vo 2021, section 4.1, Figure 6): step toggles every |width| cycles, the sign of the
// width is the direction.
//
// The trigger starts every axis anew: step low, direction as the sign says, the first rising edge |width| cycles after
// the trigger edge. There is no count: a tick of T cycles gets as many pulses as fit, ceil(floor((T-1)/|width|) / 2).
// The next trigger cuts a pulse that is still high, down to one cycle. Direction set-up is |width| cycles, hold is what
// the last pulse happens to leave. The width stands until another is written, so the axis goes on when nobody writes.
//
// `stop_i` ends the run: no rising edge from the next clock edge on, a high pulse keeps its width.
`include "assert.svh"

module pulse_width_gen #(
  parameter logic signed [31:0] EmittedReset = 0  // start value of emitted_o, for tests of its wrap
) (
  input  logic               clk_i,
  input  logic               rst_ni,     // synchronous
  input  logic               trigger_i,  // one cycle: width_i becomes active
  input  logic signed [31:0] width_i,    // half period in cycles, signed; 0: no pulses
  input  logic               stop_i,     // level
  output logic               step_o,
  output logic               dir_o,      // 1: positive; stays while the width is 0
  output logic signed [31:0] emitted_o   // rising edges since reset, signed by direction; wraps
);

  logic        running_q;
  logic [31:0] width_q;   // cycles
  logic [31:0] left_q;    // cycles to the next toggle; 1: with the next clock edge

  // A function, so that a simulator evaluates it in the trigger cycle only.
  function automatic logic [31:0] magnitude(input logic signed [31:0] width);
    magnitude = width[31] ? -width : width;
  endfunction

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      step_o    <= 1'b0;
      dir_o     <= 1'b0;
      emitted_o <= EmittedReset;
      running_q <= 1'b0;
      width_q   <= '0;
      left_q    <= '0;
    end else if (trigger_i && !stop_i) begin
      step_o    <= 1'b0;
      running_q <= width_i != '0;
      width_q   <= magnitude(width_i);
      left_q    <= magnitude(width_i);
      if (width_i != '0) dir_o <= !width_i[31];
    end else if (running_q || step_o) begin
      left_q <= left_q - 32'd1;
      if (left_q == 32'd1) begin
        left_q <= width_q;
        step_o <= !step_o && running_q && !stop_i;
        if (!step_o && running_q && !stop_i) emitted_o <= dir_o ? emitted_o + 32'sd1 : emitted_o - 32'sd1;
      end
      if (stop_i) running_q <= 1'b0;
    end
  end

`ifdef ASSERT_ON
  logic step_before_q, dir_before_q, stop_before_q, trigger_before_q;
  always_ff @(posedge clk_i) begin
    step_before_q    <= rst_ni && step_o;
    dir_before_q     <= rst_ni && dir_o;
    stop_before_q    <= stop_i;
    trigger_before_q <= rst_ni && trigger_i;
  end

  `ASSERT(NoRiseAfterStop, !(step_o && !step_before_q && stop_before_q))
  `ASSERT(DirChangesOnATriggerOnly, dir_o == dir_before_q || trigger_before_q)
  `ASSERT(NoRiseOnATrigger, !(step_o && !step_before_q && trigger_before_q))
`endif

  `COVER(TriggerEndsAHighPulse, trigger_i && !stop_i && step_o)
  `COVER(StopOfAHighPulse, stop_i && step_o)
  `COVER(StopBetweenPulses, stop_i && running_q && !step_o)
  `COVER(WidthOfZeroStops, trigger_i && !stop_i && running_q && width_i == '0)
  `COVER(Reversal, trigger_i && !stop_i && width_i != '0 && dir_o == width_i[31])

endmodule
