// PWM output of the timer pair: timer 0 sets the period and starts the pulse, timer 1 ends it.
//
// Each end of timer 0 decides about the next period. The next period has a pulse if timer 1 ended since the previous
// end of timer 0, or was stopped at the previous end, or is stopped now. An end of timer 1 in the same clock does not
// count. A high time of a whole period or more therefore gives constant 0, as in the vendor's core; at most one pulse
// of a whole period comes before. A stopped timer 1 gives constant 1. The first period after its start has a pulse.
`include "assert.svh"

module timer_pwm (
  input  logic clk_i,
  input  logic rst_ni,          // synchronous
  input  logic enable_i,        // 0 clears the output one clock later
  input  logic period_ends_i,   // timer 0 expires at the coming clock edge
  input  logic high_ends_i,     // timer 1 expires at the coming clock edge
  input  logic high_runs_i,     // ENT of timer 1: it counts
  output logic pwm_o            // changes in the same clock as the GenerateOut pulses
);

  logic expired_q;  // timer 1 has ended since the last end of timer 0, or was stopped at that end

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
