// timer_core in PWM mode: period, high time and the constant levels of the pin.
//
// Counting down, the period is TLR0 + 2 and the high time TLR1 + 2 clocks. Counting up, replace TLR by 2^32 - 1 - TLR.
// Single clocks prove a statement about up to 2^32 clocks: a pulse of timer 0 loads two numbers, each clock decrements
// them, and the next pulse and the fall of the pin must come exactly when they have reached their end.
`include "assert.svh"
`default_nettype none

module timer_pwm_proof (
`include "timer_core_inputs.svh"
);

`include "timer_core_outputs.svh"
  timer_core_flat u_dut (.*, .clk_gated_i(clk_i));

  `RESET_FIRST

  // PWM mode with both timers running and timer 0 reloading; any other bits.
  (* hierconn *) wire \u_dut.u_flat.freeze ;
  logic        mode, pulses, runs, ent0, ent1;
  logic [31:0] low0, low1;  // clocks from the load value to the end of the range
  logic [65:0] settings;
  assign mode     = {tcsr0_rdata_o[11], tcsr0_rdata_o[9], tcsr0_rdata_o[2], tcsr0_rdata_o[0]} == 4'b0110 &&
                    {tcsr1_rdata_o[9], tcsr1_rdata_o[2], tcsr1_rdata_o[0]} == 3'b110;
  assign ent0     = tcsr0_rdata_o[7];
  assign ent1     = tcsr1_rdata_o[7];
  assign pulses   = mode && ent0 && ent1 && tcsr0_rdata_o[5:4] == 2'b01 && !tcsr1_rdata_o[5];
  assign runs     = !\u_dut.u_flat.freeze ;
  assign low0     = tcsr0_rdata_o[1] ? tlr0_rdata_o : ~tlr0_rdata_o;
  assign low1     = tcsr1_rdata_o[1] ? tlr1_rdata_o : ~tlr1_rdata_o;
  assign settings = {tcsr1_rdata_o[1], tlr1_rdata_o, tcsr0_rdata_o[1], tlr0_rdata_o};

  // The mode acts one clock after its bits.
  logic mode_q, mode2_q, pulses_q, ent0_q, ent1_q, pwm_q;
  always_ff @(posedge clk_i) begin
    mode_q   <= rst_ni && mode;
    mode2_q  <= rst_ni && mode_q;
    pulses_q <= rst_ni && pulses;
    ent0_q   <= ent0;
    ent1_q   <= ent1;
    pwm_q    <= rst_ni && pwm_o;
  end

  // A period is steady from a pulse of timer 0 as long as no setting changes. wrapped: the clocks that show the wrapped
  // value; then timer 0 ends after rest0_q + 1 clocks and timer 1 after rest1_q + 1, unless it has ended already.
  logic        begins, steady, steady_q, whole_q, wrapped, wrapped_q, ended, ended_q, ends0_q, ends1_q;
  logic [65:0] settings_q;
  logic [31:0] rest0_q, rest1_q;
  assign begins  = mode2_q && mode_q && pulses_q && generate_o[0];
  assign steady  = mode_q && pulses && settings == settings_q && (begins || steady_q);
  assign wrapped = begins || wrapped_q;
  assign ended   = !wrapped && ended_q;

  always_ff @(posedge clk_i) begin
    settings_q <= settings;
    steady_q   <= rst_ni && steady;
    if (begins) whole_q <= steady_q;  // the previous period was a steady one, with the same settings
    wrapped_q  <= wrapped && !runs;
    ended_q    <= ended || (runs && !wrapped && rest1_q == '0);
    ends0_q    <= runs && !wrapped && rest0_q == '0;
    ends1_q    <= runs && !wrapped && !ended && rest1_q == '0;
    if (runs) {rest1_q, rest0_q} <= wrapped ? {low1, low0} : {rest1_q - 32'd1, rest0_q - 32'd1};
  end

  logic whole;
  assign whole = begins ? steady_q : whole_q;

  `ASSERT(BothTimersPulseAtTheirEnds, !steady_q || generate_o == {ends1_q, ends0_q})
  `ASSERT(HighTimeIsExact, !(steady && whole) || pwm_o == (low1 < low0 && !ended))
  `ASSERT(AFirstPeriodHasOnePulseAtMost, !steady || (ended ? !pwm_o : begins || !steady_q || pwm_o == pwm_q))
  `ASSERT(Timer0AloneIsConstantOne, !(mode2_q && !ent1_q && (pwm_q || generate_o[0])) || pwm_o)
  `ASSERT(Timer1AloneIsConstantZeroFromItsEnd,
          !(mode2_q && !ent0_q) || (!(pwm_o && generate_o[1]) && (pwm_q || !pwm_o)))
  `ASSERT(LowOutsideTheMode, mode2_q || !pwm_o)

  // Flops that no port shows. `flatten` connects these nets to the flops of the same names.
  (* hierconn *) wire [1:0] \u_dut.u_flat.u_timer0.u_counter.left_q , \u_dut.u_flat.u_timer1.u_counter.left_q ;
  (* hierconn *) wire \u_dut.u_flat.u_pwm.expired_q , \u_dut.u_flat.pwm_mode_q , \u_dut.u_flat.tcsr_written_q ;
  `ASSERT(ModeFollowsTheBits, \u_dut.u_flat.pwm_mode_q == mode_q && (\u_dut.u_flat.tcsr_written_q || mode_q == mode))
  logic [31:0] left0, left1;  // clocks from the counts to the ends of the range
  assign left0 = tcsr0_rdata_o[1] ? tcr0_rdata_o : ~tcr0_rdata_o;
  assign left1 = tcsr1_rdata_o[1] ? tcr1_rdata_o : ~tcr1_rdata_o;
  `ASSERT(CountersHaveWhatIsLeft,
          (!generate_o[0] || \u_dut.u_flat.u_timer0.u_counter.left_q != '0) &&
          (!generate_o[1] || \u_dut.u_flat.u_timer1.u_counter.left_q != '0) &&
          (!steady || \u_dut.u_flat.u_timer0.u_counter.left_q == {1'b0, wrapped}) &&
          (!steady || wrapped || left0 == rest0_q) &&
          (!steady || wrapped || \u_dut.u_flat.u_timer1.u_counter.left_q == {1'b0, ended}) &&
          (!steady || wrapped || ended || left1 == rest1_q))
  `ASSERT(BothCountTogether, !steady || wrapped || (ended ? low1 < low0 :
                             (rest1_q < rest0_q) == (low1 < low0) && (rest1_q == rest0_q) == (low1 == low0)))
  `ASSERT(RemembersTheEndOfTimer1, !steady || \u_dut.u_flat.u_pwm.expired_q == ended)

  `REACH(ShortestHighTime, steady && whole && ended && pwm_q && low1 == '0)
  `REACH(ConstantZero, steady && whole && !begins && low1 == low0 + 32'd1)
  `REACH(ConstantZeroIfBothAreEqual, steady && whole && low1 == low0 && generate_o == 2'b11)
  `REACH(AWholeFirstPeriodHigh, steady && pwm_o && low1 > low0 && !wrapped && rest0_q == '0)
  `REACH(StaysOne, mode2_q && !ent1_q && pwm_q && generate_o[0])
  `REACH(GoesToZero, mode2_q && !ent0_q && pwm_q && generate_o[1])

endmodule

`default_nettype wire
