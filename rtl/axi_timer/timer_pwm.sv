// PWM output of the timer pair: timer 0 sets the period and starts the pulse, timer 1 ends it.
//
// Each end of timer 0 decides about the next period. It has a pulse if timer 1 has ended since the end of timer 0
// before, or was stopped at that one or is at this one; an end of timer 1 in the same clock does not count. Hence a
// high time of a whole period or more is constant 0, as in the vendor's core, at the latest after one pulse that ends
// with its period. A stopped timer 1 makes constant 1, and the period after its start still has its pulse.
`include "assert.svh"

module timer_pwm (
  input  logic clk_i,
  input  logic rst_ni,          // synchronous
  input  logic enable_i,        // 0: the output is 0 one clock later
  input  logic period_ends_i,   // timer 0 expires at the coming clock edge
  input  logic high_ends_i,     // timer 1 does
  input  logic high_runs_i,     // ENT of timer 1
  output logic pwm_o            // changes in the clock of the GenerateOut pulses
);

  logic expired_q;  // timer 1 has ended since the last end of timer 0, or was stopped at it

  always_ff @(posedge clk_i) begin
    if (!rst_ni || !enable_i) begin
      pwm_o     <= 1'b0;
      expired_q <= 1'b0;
    end else if (period_ends_i || high_ends_i) begin
      expired_q <= !period_ends_i || !high_runs_i;
      pwm_o     <= period_ends_i && (expired_q || !high_runs_i);
    end
  end

`ifdef ASSERT_ON
  logic enabled_q;
  always_ff @(posedge clk_i) enabled_q <= rst_ni && enable_i;
`endif

  `ASSERT(LowWhileDisabled, !pwm_o || enabled_q)

  `COVER(Rises, enable_i && period_ends_i && !pwm_o && expired_q && high_runs_i)
  `COVER(ConstantOne, enable_i && period_ends_i && pwm_o && !high_runs_i)
  `COVER(ConstantOneIsLeft, enable_i && period_ends_i && high_ends_i && expired_q)
  `COVER(Falls, enable_i && high_ends_i && !period_ends_i && pwm_o)
  `COVER(FallsWithThePeriod, enable_i && period_ends_i && high_ends_i && !expired_q && pwm_o)
  `COVER(HighTimeCutOff, enable_i && period_ends_i && !high_ends_i && !expired_q && high_runs_i && pwm_o)

endmodule
