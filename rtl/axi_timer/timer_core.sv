// Two timers and the functions that couple them: capture pins, freeze, ENALL, cascade, pulse width modulation and one
// interrupt.
//
// Cascade (CASC in TCSR0): {TCR1, TCR0} is one 64-bit counter with the mode, flag and pins of timer 0. Timer 1 counts
// the roll-overs of timer 0 on the same clock edge. LOAD of each TCSR still loads its own half. The wrapped value
// is visible for three clocks, so the period is the 64-bit load value + 4. T1INT keeps its value and raises no
// interrupt.
//
// PWM (PWMA, PWMB and GENT of both, no capture mode, no cascade): timer 1 reloads together with timer 0 and holds its
// wrapped value until then, so each period starts with one pulse. While ENT0 is 0 timer 0 does not reload: timer 1 then
// reloads by its own ARHT, and its next end lowers the pin. A change of the mode bits takes effect one clock later than
// a change of any other bit.
`include "assert.svh"
`include "axi_timer_reg_types.svh"

module timer_core #(
  parameter bit Gen0Assert  = 1'b1,  // active levels: GenerateOut of timers 0 and 1, capture pins of timers 0 and 1
  parameter bit Gen1Assert  = 1'b1,
  parameter bit Trig0Assert = 1'b1,
  parameter bit Trig1Assert = 1'b1
) (
  input  logic        clk_i,
  input  logic        rst_ni,          // synchronous
  input  logic        clk_gated_i,     // of all flops but counters and synchronisers
  output logic        active_o,        // clock request; 0: the next edge changes no flop of clk_gated_i

  // At most one write strobe in a clock. No read has a side effect.
  /* verilator tracing_off */
  input  axi_timer_reg2hw_t reg2hw_i,
  output axi_timer_hw2reg_t hw2reg_o,
  /* verilator tracing_on */

  input  logic [1:0]  capture_trig_i,  // asynchronous; bit i: timer i. An active edge stores TCR three clocks later
  input  logic        freeze_i,        // asynchronous; 1 stops both counters two clocks later
  output logic [1:0]  generate_o,      // bit i: active for one clock per period of timer i, from a flop
  output logic        pwm_o,           // from a flop
  output logic        irq_o            // level until acknowledged, from a flop
);

  logic        tcsr0_we, tlr0_we, tcsr1_we, tlr1_we, unused;
  logic [31:0] wdata, tcr1;
  logic [3:0]  wstrb;
  assign tcsr0_we = reg2hw_i.tcsr0_we;
  assign tlr0_we  = reg2hw_i.tlr0_we;
  assign tcsr1_we = reg2hw_i.tcsr1_we;
  assign tlr1_we  = reg2hw_i.tlr1_we;
  assign wdata    = reg2hw_i.wdata;
  assign wstrb    = reg2hw_i.wstrb;
  assign unused   = ^{reg2hw_i.tcsr0_re, reg2hw_i.tlr0_re, reg2hw_i.tcr0_re, reg2hw_i.tcsr1_re, reg2hw_i.tlr1_re,
                      reg2hw_i.tcr1_re};

  // Pins. The capture pins are converted to active high before their flops.
  logic       freeze;
  logic [1:0] trigger, trigger_q, trigger_edge_q;

  sync_2ff #(.Width(1)) u_sync_freeze (
    .clk_i,
    .rst_ni,
    .async_i(freeze_i),
    .level_o(freeze)
  );

  sync_2ff #(.Width(2)) u_sync_trigger (
    .clk_i,
    .rst_ni,
    .async_i(capture_trig_i ^ {!Trig1Assert, !Trig0Assert}),
    .level_o(trigger)
  );

  always_ff @(posedge clk_gated_i) begin
    if (!rst_ni) begin
      trigger_q      <= '0;
      trigger_edge_q <= '0;
    end else if (trigger != trigger_q || trigger_edge_q != '0) begin
      trigger_q      <= trigger;
      trigger_edge_q <= trigger & ~trigger_q;
    end
  end

  // Mode bits of the pair.
  logic enall_q, casc_q;
  logic tcsr_written_q, pwm_mode_q;
  logic ready0, ready1;

  always_ff @(posedge clk_gated_i) begin
    if (!rst_ni) begin
      enall_q        <= 1'b0;
      casc_q         <= 1'b0;
      tcsr_written_q <= 1'b0;
      pwm_mode_q     <= 1'b0;
    end else begin
      if (tcsr0_we || tcsr1_we) begin
        tcsr_written_q <= 1'b1;
        if (wstrb[1]) enall_q <= wdata[10];
        if (tcsr0_we && wstrb[1]) casc_q <= wdata[11];
      end else begin
        tcsr_written_q <= 1'b0;
      end
      if (tcsr_written_q) pwm_mode_q <= ready0 && ready1 && !casc_q;
    end
  end

  logic [31:0] tcsr0, tcsr1;
  logic        down0, wraps0, reloads0, captures0, expires0, interrupt0;
  logic        ent0, ent1, expires1, interrupt1;
  logic        active0, active1;
  logic        restart1;  // timer 1 reloads with timer 0

  // No default assignment at the top: in PWM mode Icarus 11 would evaluate such a block without end.
  assign restart1 = reloads0 ? casc_q || (pwm_mode_q && ent1) : 1'b0;

  assign hw2reg_o.tcsr0_rdata = tcsr0 | {20'b0, casc_q, enall_q, 10'b0};
  assign hw2reg_o.tcsr1_rdata = tcsr1 | {21'b0, enall_q, 10'b0};
  assign hw2reg_o.tcr1_rdata  = tcr1;

  timer_channel #(.GenAssert(Gen0Assert)) u_timer0 (
    .clk_i,
    .rst_ni,
    .clk_gated_i,
    .active_o      (active0),
    .tcsr_we_i     (tcsr0_we),
    .tlr_we_i      (tlr0_we),
    .wdata_i       (wdata),
    .wstrb_i       (wstrb),
    .other_we_i    (tcsr1_we),
    .tcsr_o        (tcsr0),
    .tlr_o         (hw2reg_o.tlr0_rdata),
    .tcr_o         (hw2reg_o.tcr0_rdata),
    .freeze_i      (freeze),
    .capture_edge_i(trigger_edge_q[0]),
    .generate_o    (generate_o[0]),
    .interrupt_o   (interrupt0),
    .lower_i       (casc_q),
    .upper_count_i (tcr1),
    .down_o        (down0),
    .wraps_o       (wraps0),
    .reloads_o     (reloads0),
    .captures_o    (captures0),
    .upper_i       (1'b0),
    .carry_i       (1'b0),
    .upper_down_i  (1'b0),
    .capture_too_i (1'b0),
    .follow_i      (1'b0),
    .restart_i     (1'b0),
    .ent_o         (ent0),
    .pwm_ready_o   (ready0),
    .expires_o     (expires0)
  );

  timer_channel #(.GenAssert(Gen1Assert)) u_timer1 (
    .clk_i,
    .rst_ni,
    .clk_gated_i,
    .active_o      (active1),
    .tcsr_we_i     (tcsr1_we),
    .tlr_we_i      (tlr1_we),
    .wdata_i       (wdata),
    .wstrb_i       (wstrb),
    .other_we_i    (tcsr0_we),
    .tcsr_o        (tcsr1),
    .tlr_o         (hw2reg_o.tlr1_rdata),
    .tcr_o         (tcr1),
    .freeze_i      (freeze),
    .capture_edge_i(trigger_edge_q[1]),
    .generate_o    (generate_o[1]),
    .interrupt_o   (interrupt1),
    .lower_i       (1'b0),
    .upper_count_i (32'b0),
    .down_o        (),
    .wraps_o       (),
    .reloads_o     (),
    .captures_o    (),
    .upper_i       (casc_q),
    .carry_i       (wraps0),
    .upper_down_i  (down0),
    .capture_too_i (captures0),
    .follow_i      (pwm_mode_q && ent0),
    .restart_i     (restart1),
    .ent_o         (ent1),
    .pwm_ready_o   (ready1),
    .expires_o     (expires1)
  );

  timer_pwm u_pwm (
    .clk_i        (clk_gated_i),
    .rst_ni,
    .enable_i     (pwm_mode_q),
    .period_ends_i(expires0),
    .high_ends_i  (expires1),
    .high_runs_i  (ent1),
    .pwm_o
  );

  // An event changes the interrupt one clock later. A new mode changes the PWM output in the clock after that.
  logic activity, activity_q;
  assign activity = active0 || active1;
  assign active_o = activity || trigger != trigger_q || trigger_edge_q != '0 || activity_q;

  always_ff @(posedge clk_gated_i) begin
    if (!rst_ni) activity_q <= 1'b0;
    else         activity_q <= activity || tcsr_written_q;
  end

  always_ff @(posedge clk_gated_i) begin
    if (!rst_ni) irq_o <= 1'b0;
    else         irq_o <= interrupt0 || (interrupt1 && !casc_q);
  end

  `COVER(Frozen, freeze)
  `COVER(Pwm, pwm_mode_q && restart1)
  `COVER(PwmOfTimer1Alone, pwm_mode_q && pwm_o && ent1 && !ent0)
  `COVER(CascadeReloads, casc_q && restart1)
  `COVER(CascadeHidesTheOtherInterrupt, casc_q && interrupt1 && !interrupt0)

endmodule
