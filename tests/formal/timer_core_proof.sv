// timer_core against a reference in every clock: registers, pins and interrupt, for all writes and all levels.
//
// The reference follows rtl/axi_timer/README.md: both counters are halves of one 64-bit number, the value after a count
// decides about the end of a period, and the pins are a history of samples. A vector of two has one bit per timer.
`include "assert.svh"
`default_nettype none

module timer_core_proof (
`include "timer_core_inputs.svh"
);

  // Timer 1 has the other active levels.
`include "timer_core_outputs.svh"
  timer_core_flat #(.Gen1Assert(1'b0), .Trig1Assert(1'b0)) u_dut (.*, .clk_gated_i(clk_i));

  `RESET_FIRST

  logic [1:0] tcsr_we, tlr_we;
  assign tcsr_we = {tcsr1_we_i, tcsr0_we_i};
  assign tlr_we  = {tlr1_we_i, tlr0_we_i};

  // Samples of the pins, active high, the newest one first.
  logic [1:0] pins1_q, pins2_q, pins3_q, pins4_q, edges;
  logic       freeze1_q, frozen_q;
  assign edges = pins3_q & ~pins4_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) {pins1_q, pins2_q, pins3_q, pins4_q, freeze1_q, frozen_q} <= '0;
    else begin
      {pins4_q, pins3_q, pins2_q, pins1_q} <= {pins3_q, pins2_q, pins1_q, !capture_trig_i[1], capture_trig_i[0]};
      {frozen_q, freeze1_q}                <= {freeze1_q, freeze_i};
    end
  end

  // The counters. more_q: TCR shows its wrapped value in this clock; the number includes the clocks that follow.
  logic [1:0]  mdt_q, udt_q, gent_q, capt_q, arht_q, load_q, enit_q, ent_q, tint_q, pwm_q;
  logic        enall_q, casc_q, pwm_mode_q;
  logic [63:0] tlr_q, tcr_q, count;
  logic [1:0]  more0_q, more0, runs, ends;
  logic        more1_q, more1, reloads;
  assign runs = frozen_q ? 2'b00 : ent_q & ~load_q;

  always_comb begin
    {more1, more0} = {more1_q, more0_q};
    count   = tcr_q;
    ends    = 2'b00;
    reloads = 1'b0;

    if (runs[0]) begin
      if (more0_q > 2'd1 && !mdt_q[0]) more0 = more0_q - 2'd1;
      else if (more0_q == 2'd1 && !mdt_q[0]) begin
        reloads = arht_q[0];
        if (reloads) more0 = '0;
      end else if (casc_q) begin
        count   = udt_q[0] ? tcr_q - 64'd1 : tcr_q + 64'd1;
        ends[0] = !mdt_q[0] && count == (udt_q[0] ? '1 : '0);
        more0   = ends[0] ? 2'd3 : 2'd0;
        if (count[63:32] != tcr_q[63:32]) more1 = 1'b0;
      end else begin
        count[31:0] = udt_q[0] ? tcr_q[31:0] - 32'd1 : tcr_q[31:0] + 32'd1;
        ends[0]     = !mdt_q[0] && count[31:0] == (udt_q[0] ? '1 : '0);
        more0       = ends[0] ? 2'd1 : 2'd0;
      end
    end
    if (reloads) count[31:0] = tlr_q[31:0];

    if (reloads && (casc_q || (pwm_mode_q && ent_q[1]))) begin
      count[63:32] = tlr_q[63:32];
      more1        = 1'b0;
    end else if (runs[1] && !casc_q) begin
      if (!more1_q || mdt_q[1]) begin
        count[63:32] = udt_q[1] ? tcr_q[63:32] - 32'd1 : tcr_q[63:32] + 32'd1;
        ends[1]      = !mdt_q[1] && count[63:32] == (udt_q[1] ? '1 : '0);
        more1        = ends[1];
      end else if (arht_q[1] && !(pwm_mode_q && ent_q[0])) begin
        count[63:32] = tlr_q[63:32];
        more1        = 1'b0;
      end
    end

    if (load_q[0]) {count[31:0], more0} = {tlr_q[31:0], 2'd0};
    if (load_q[1]) {count[63:32], more1} = {tlr_q[63:32], 1'b0};
  end

  // The PWM pin. A timer 1 that has ended, or is stopped, makes the next end of timer 0 raise it.
  logic pin_q, spent_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) pwm_mode_q <= 1'b0;
    else pwm_mode_q <= (pwm_q & gent_q & ~mdt_q) == 2'b11 && !casc_q;
    if (!rst_ni || !pwm_mode_q) {pin_q, spent_q} <= 2'b00;
    else if (ends[0]) {pin_q, spent_q} <= {spent_q || !ent_q[1], !ent_q[1]};
    else if (ends[1]) {pin_q, spent_q} <= 2'b01;
  end

  // Registers. Events win over writes.
  logic [1:0] captures, pulse_q;
  logic       irq_q;
  assign captures = edges & ent_q & mdt_q & capt_q & (arht_q | ~tint_q) & {!casc_q, 1'b1};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {mdt_q, udt_q, gent_q, capt_q, arht_q, load_q, enit_q, ent_q, tint_q, pwm_q, enall_q, casc_q} <= '0;
      {tlr_q, tcr_q, more0_q, more1_q, pulse_q, irq_q} <= '0;
    end else begin
      for (int t = 0; t < 2; t++) begin
        if (tcsr_we[t] && wstrb_i[0])
          {ent_q[t], enit_q[t], load_q[t], arht_q[t], capt_q[t], gent_q[t], udt_q[t], mdt_q[t]} <= wdata_i[7:0];
        if (tcsr_we[t] && wstrb_i[1]) begin
          pwm_q[t] <= wdata_i[9];
          if (wdata_i[8]) tint_q[t] <= 1'b0;
        end
        for (int b = 0; b < 32; b++) if (tlr_we[t] && wstrb_i[b / 8]) tlr_q[32 * t + b] <= wdata_i[b];
      end
      if (tcsr_we[0] && wstrb_i[1]) casc_q <= wdata_i[11];
      if (tcsr_we != '0 && wstrb_i[1]) begin
        enall_q <= wdata_i[10];
        if (wdata_i[10]) ent_q <= 2'b11;
      end
      for (int t = 0; t < 2; t++) if (ends[t] || captures[t]) tint_q[t] <= 1'b1;
      if (captures[0]) tlr_q[31:0] <= tcr_q[31:0];
      if (captures[1] || (captures[0] && casc_q)) tlr_q[63:32] <= tcr_q[63:32];
      {tcr_q, more1_q, more0_q} <= {count, more1, more0};
      pulse_q <= ends & gent_q;
      irq_q   <= (tint_q & enit_q & {!casc_q, 1'b1}) != '0;
    end
  end

  `ASSERT(Tcsr0IsAsWritten, tcsr0_rdata_o == {20'd0, casc_q, enall_q, pwm_q[0], tint_q[0], ent_q[0], enit_q[0],
                                              load_q[0], arht_q[0], capt_q[0], gent_q[0], udt_q[0], mdt_q[0]})
  `ASSERT(Tcsr1IsAsWritten, tcsr1_rdata_o == {21'd0, enall_q, pwm_q[1], tint_q[1], ent_q[1], enit_q[1],
                                              load_q[1], arht_q[1], capt_q[1], gent_q[1], udt_q[1], mdt_q[1]})
  `ASSERT(TlrIsWrittenOrCaptured, {tlr1_rdata_o, tlr0_rdata_o} == tlr_q)
  `ASSERT(TcrCountsLoadsAndReloads, {tcr1_rdata_o, tcr0_rdata_o} == tcr_q)
  `ASSERT(GeneratesAtEachEnd, generate_o == {!pulse_q[1], pulse_q[0]})
  `ASSERT(PwmIsSetAndCleared, pwm_o == pin_q)
  `ASSERT(InterruptIsTheOrOfTheFlags, irq_o == irq_q)

  // Flops that no port shows. `flatten` connects these nets to the flops of the same names.
  (* hierconn *) wire [1:0] \u_dut.u_flat.u_timer0.u_counter.left_q , \u_dut.u_flat.u_timer1.u_counter.left_q ;
  (* hierconn *) wire \u_dut.u_flat.u_pwm.expired_q , \u_dut.u_flat.pwm_mode_q , \u_dut.u_flat.tcsr_written_q ;
  (* hierconn *) wire \u_dut.u_flat.u_sync_freeze.first_q , \u_dut.u_flat.u_sync_freeze.second_q ;
  (* hierconn *) wire [1:0] \u_dut.u_flat.u_sync_trigger.first_q , \u_dut.u_flat.u_sync_trigger.second_q ;
  (* hierconn *) wire [1:0] \u_dut.u_flat.trigger_q , \u_dut.u_flat.trigger_edge_q ;
  `ASSERT(ShowsTheWrappedValue, \u_dut.u_flat.u_timer0.u_counter.left_q == more0_q &&
                                \u_dut.u_flat.u_timer1.u_counter.left_q == {1'b0, more1_q} &&
                                (!pulse_q[0] || more0_q != '0) && (!pulse_q[1] || more1_q))
  `ASSERT(RemembersTheEndOfTimer1, \u_dut.u_flat.u_pwm.expired_q == spent_q)
  `ASSERT(PwmModeFollowsTheBits, \u_dut.u_flat.pwm_mode_q == pwm_mode_q && (\u_dut.u_flat.tcsr_written_q ||
                                 pwm_mode_q == ((pwm_q & gent_q & ~mdt_q) == 2'b11 && !casc_q)))
  `ASSERT(FreezesTwoClocksLater, {\u_dut.u_flat.u_sync_freeze.second_q , \u_dut.u_flat.u_sync_freeze.first_q } ==
                                 {frozen_q, freeze1_q})
  `ASSERT(CapturesThreeClocksLater, {\u_dut.u_flat.trigger_q , \u_dut.u_flat.u_sync_trigger.second_q ,
                                     \u_dut.u_flat.u_sync_trigger.first_q , \u_dut.u_flat.trigger_edge_q } ==
                                    {pins3_q, pins2_q, pins1_q, edges})

  `REACH(PwmFallsAtTheEndOfTimer1, pwm_mode_q && pin_q && ends == 2'b10)
  `REACH(PwmStaysLowIfBothEnd, pwm_mode_q && ends == 2'b11 && !spent_q)
  `REACH(CaptureOverwrites, captures[1] && arht_q[1] && tint_q[1] && tlr_we[1])
  `REACH(CaptureIsDropped, edges[0] && ent_q[0] && mdt_q[0] && capt_q[0] && !captures[0] && !frozen_q)
  `REACH(CapturesBothHalves, captures[0] && casc_q)
  `REACH(EnallStartsBoth, enall_q && ent_q == 2'b11 && tcr_q[31:0] == 32'd1 && tcr_q[63:32] == 32'd1)
  `REACH(OneShotHolds, more0_q == 2'd1 && runs[0] && !arht_q[0])
  `REACH(TheFlagWinsOverItsClear, ends[1] && tcsr_we[1] && wstrb_i[1] && wdata_i[8])

endmodule

`default_nettype wire
