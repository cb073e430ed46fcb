// One axis of Vo's pulse generator (Vo 2021, section 4.1, Figure 6). Step toggles every |width| cycles; the sign of the
// width is the direction.
//
// The trigger restarts the generator: step low, direction from the sign, the first rising edge |width| cycles after the
// trigger edge. Pulses are not counted: a tick of T cycles has as many pulses as fit, ceil(floor((T-1)/|width|) / 2).
// The next trigger cuts a pulse that is still high, down to one cycle. The direction set-up time is |width| cycles, the
// hold time is not controlled. The width stays active until it is replaced, so the axis also runs without new writes.
//
// `stop_i` ends the run: there is no rising edge from the next clock edge on, and a high pulse keeps its width.
`include "assert.svh"

module pulse_width_gen #(
  parameter logic signed [31:0] EmittedReset = 0  // initial value of emitted_o, for tests of its wrap-around
) (
  input  logic               clk_i,
  input  logic               rst_ni,     // synchronous
  input  logic               trigger_i,  // one cycle: width_i becomes active
  input  logic signed [31:0] width_i,    // half period in cycles, signed; 0: no pulses
  input  logic               stop_i,     // level: no rising edge from the next clock edge on
  (* IOB = "TRUE" *)
  output logic               step_o,     // a rising edge is one pulse
  (* IOB = "TRUE" *)
  output logic               dir_o,      // 1: positive; a width of 0 keeps it
  output logic signed [31:0] emitted_o   // rising edges since reset, signed by direction; wraps
);

  logic        running_q;
  logic [31:0] width_q;   // cycles
  logic [31:0] left_q;    // cycles until the next toggle; 1: at the next clock edge

  // It is a function so that the simulator evaluates it only in the trigger cycle.
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
