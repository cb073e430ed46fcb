// The registers of one timer (TCSR, TLR, TCR) around its counter, in generate mode.
//
// TINT is set by every wrap, whether or not ENIT lets it out; a wrap wins over a write of 1 in the same clock. Mode
// bits without a function here (MDT, CAPT, PWM, ENALL, CASC) read 0.
`include "assert.svh"

module timer_channel (
  input  logic        clk_i,
  input  logic        rst_ni,       // synchronous

  input  logic        tcsr_we_i,    // write strobes with their data, in the same clock
  input  logic        tlr_we_i,
  input  logic [31:0] wdata_i,
  input  logic [3:0]  wstrb_i,      // one bit per byte
  output logic [31:0] tcsr_o,       // register values as software reads them
  output logic [31:0] tlr_o,
  output logic [31:0] tcr_o,

  output logic        generate_o,   // one clock per wrap if GENT: the clock in which TCR shows the wrapped value
  output logic        interrupt_o   // TINT && ENIT
);

  logic udt_q, gent_q, arht_q, load_q, enit_q, ent_q, tint_q;
  logic wraps;

  assign tcsr_o      = {23'b0, tint_q, ent_q, enit_q, load_q, arht_q, 1'b0, gent_q, udt_q, 1'b0};
  assign interrupt_o = tint_q && enit_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {ent_q, enit_q, load_q, arht_q, gent_q, udt_q} <= '0;
      tint_q     <= 1'b0;
      generate_o <= 1'b0;
      tlr_o      <= '0;
    end else begin
      if (tcsr_we_i) begin
        if (wstrb_i[0]) begin
          {ent_q, enit_q, load_q, arht_q} <= wdata_i[7:4];
          {gent_q, udt_q}                 <= wdata_i[2:1];
        end
        if (wstrb_i[1] && wdata_i[8]) tint_q <= 1'b0;
      end
      if (wraps) tint_q <= 1'b1;
      generate_o <= wraps && gent_q;
      if (tlr_we_i) begin
        for (int i = 0; i < 4; i++) if (wstrb_i[i]) tlr_o[i*8+:8] <= wdata_i[i*8+:8];
      end
    end
  end

  timer_counter u_counter (
    .clk_i,
    .rst_ni,
    .load_i      (load_q),
    .enable_i    (ent_q),
    .down_i      (udt_q),
    .reload_i    (arht_q),
    .load_value_i(tlr_o),
    .count_o     (tcr_o),
    .wraps_o     (wraps)
  );

`ifdef ASSERT_ON
  logic generated_q, wrapped_q;
  always_ff @(posedge clk_i) begin
    generated_q <= rst_ni && generate_o;
    wrapped_q   <= rst_ni && wraps;
  end
`endif

  `ASSERT(GeneratesForOneClock, !(generate_o && generated_q))  // the shortest period is two clocks
  `ASSERT(GeneratesOnlyAtAWrap, !generate_o || wrapped_q)
  `ASSERT(EveryWrapLeavesTheFlag, !wrapped_q || tint_q)

endmodule
