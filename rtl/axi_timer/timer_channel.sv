// The registers of one timer (TCSR, TLR, TCR) around its counter, in generate and capture mode.
//
// The end of a period and a capture set TINT, whether or not ENIT enables the interrupt. The event wins over a
// write-1-to-clear in the same clock. ENALL and CASC belong to both timers and are in timer_core.
//
// A capture stores TCR in TLR. It wins over a write of TLR in the same clock. Without ARHT a capture is dropped while
// TINT is 1, also in the clock of the clear. The first captured value stays until software has acknowledged it.
`include "assert.svh"

module timer_channel #(
  parameter bit GenAssert = 1'b1      // active level of generate_o
) (
  input  logic        clk_i,
  input  logic        rst_ni,         // synchronous
  input  logic        clk_gated_i,    // of the registers
  output logic        active_o,       // clock request; 0: the next edge changes no flop of clk_gated_i

  input  logic        tcsr_we_i,      // write strobes, valid in the same clock as their data
  input  logic        tlr_we_i,
  input  logic [31:0] wdata_i,        // write data of all strobes
  input  logic [3:0]  wstrb_i,        // one bit per byte
  input  logic        other_we_i,     // write strobe of the TCSR of the other timer; its ENALL sets ENT here too
  output logic [31:0] tcsr_o,         // register values as software reads them, without ENALL and CASC
  output logic [31:0] tlr_o,
  output logic [31:0] tcr_o,

  input  logic        freeze_i,       // stops the counter
  input  logic        capture_edge_i, // one clock per active edge of the capture pin
  output logic        generate_o,     // if GENT: active for one clock per period, when TCR first has the wrapped value
  output logic        interrupt_o,    // TINT && ENIT

  // Lower half of a cascade.
  input  logic        lower_i,        // a period ends only if the upper half is at its end value too
  input  logic [31:0] upper_count_i,  // TCR of the upper half
  output logic        down_o,         // UDT
  output logic        wraps_o,        // TCR rolls over at the coming clock edge
  output logic        reloads_o,      // the coming clock edge replaces the wrapped value
  output logic        captures_o,     // a capture is stored at the coming clock edge

  // Upper half of a cascade: of TCSR only LOAD has an effect.
  input  logic        upper_i,        // 1: this timer is the upper half
  input  logic        carry_i,        // count enable
  input  logic        upper_down_i,   // count direction, 1 is down
  input  logic        capture_too_i,  // one cycle: stores TCR in TLR

  // Pulse width modulation.
  input  logic        follow_i,       // the reload comes from restart_i, not from ARHT
  input  logic        restart_i,      // one cycle: loads TLR into the counter
  output logic        ent_o,          // ENT
  output logic        pwm_ready_o,    // PWM bit and GENT in generate mode
  output logic        expires_o       // a period ends at the coming clock edge
);

  logic armed;
  logic mdt_q, udt_q, gent_q, capt_q, arht_q, load_q, enit_q, ent_q, tint_q, pwm_q;

  assign tcsr_o = {22'b0, pwm_q, tint_q, ent_q, enit_q, load_q, arht_q, capt_q, gent_q, udt_q, mdt_q};

  assign interrupt_o = tint_q && enit_q;
  assign down_o      = udt_q;
  assign ent_o       = ent_q;
  assign pwm_ready_o = pwm_q && gent_q && !mdt_q;

  always_comb begin
    armed      = 1'b0;
    captures_o = 1'b0;
    if (capture_edge_i) begin
      armed      = ent_q && mdt_q && capt_q && !upper_i;
      captures_o = armed && (arht_q || !tint_q);
    end
  end

  assign active_o = tcsr_we_i || tlr_we_i || other_we_i || expires_o || capture_edge_i || capture_too_i ||
                    generate_o == GenAssert;

  always_ff @(posedge clk_gated_i) begin
    if (!rst_ni) begin
      {ent_q, enit_q, load_q, arht_q, capt_q, gent_q, udt_q, mdt_q} <= '0;
      {pwm_q, tint_q} <= '0;
      generate_o      <= !GenAssert;
      tlr_o           <= '0;
    end else begin
      if (tcsr_we_i || other_we_i) begin
        if (tcsr_we_i && wstrb_i[0]) {ent_q, enit_q, load_q, arht_q, capt_q, gent_q, udt_q, mdt_q} <= wdata_i[7:0];
        if (tcsr_we_i && wstrb_i[1]) pwm_q <= wdata_i[9];
        if (tcsr_we_i && wstrb_i[1] && wdata_i[8]) tint_q <= 1'b0;
        if (wstrb_i[1] && wdata_i[10]) ent_q <= 1'b1;
      end
      if (tlr_we_i) begin
        for (int i = 0; i < 4; i++) if (wstrb_i[i]) tlr_o[i*8+:8] <= wdata_i[i*8+:8];
      end
      generate_o <= (expires_o && gent_q) == GenAssert;
      if (expires_o) tint_q <= 1'b1;
      if (captures_o) begin
        tint_q <= 1'b1;
        tlr_o  <= tcr_o;
      end
      if (upper_i) begin
        if (capture_too_i) tlr_o <= tcr_o;
      end
    end
  end

  timer_counter u_counter (
    .clk_i,
    .rst_ni,
    .load_i      (load_q),
    .restart_i,
    .step_i      (ent_q && !freeze_i),
    .down_i      (udt_q),
    .free_i      (mdt_q),
    .reload_i    (arht_q),
    .follow_i,
    .lower_i,
    .upper_count_i,
    .load_value_i(tlr_o),
    .upper_i,
    .carry_i,
    .upper_down_i,
    .count_o     (tcr_o),
    .wraps_o,
    .expires_o,
    .reloads_o
  );

`ifdef ASSERT_ON
  logic generated_q, expired_q, captured_q;
  always_ff @(posedge clk_i) begin
    generated_q <= rst_ni && generate_o == GenAssert;
    expired_q   <= rst_ni && expires_o;
    captured_q  <= rst_ni && captures_o;
  end
`endif

  `ASSERT(GeneratesForOneClock, !(generate_o == GenAssert && generated_q))  // the shortest period is two clocks
  `ASSERT(GeneratesOnlyAtAnEnd, generate_o != GenAssert || expired_q)
  `ASSERT(EveryEventLeavesTheFlag, !(expired_q || captured_q) || tint_q)

  `COVER(CaptureKept, captures_o && !arht_q)
  `COVER(CaptureOverwrites, captures_o && tint_q)
  `COVER(CaptureDiscarded, armed && !captures_o)
  `COVER(CaptureOfBothHalves, upper_i && capture_too_i)
  `COVER(FlagSetWhileItIsCleared, expires_o && tcsr_we_i && wstrb_i[1] && wdata_i[8])
  `COVER(ExpiresWithoutInterrupt, expires_o && !enit_q)
  `COVER(EnabledByTheOtherTimer, other_we_i && wstrb_i[1] && wdata_i[10])

endmodule
