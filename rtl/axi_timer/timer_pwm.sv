// PWM output of the timer pair: timer 0 sets the period and starts the pulse, timer 1 ends it.
//
// The pulse starts at an end of timer 0 only if timer 1 stands still, which makes a constant 1, or has ended since the
// last one: a high time of a whole period or more gives constant 0, as the vendor's core does. An end of timer 1 wins
// over an end of timer 0 in the same clock.
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

  logic expired_q;  // timer 1 has ended since the last end of timer 0

  always_ff @(posedge clk_i) begin
    if (!rst_ni || !enable_i) begin
      pwm_o     <= 1'b0;
      expired_q <= 1'b0;
    end else if (period_ends_i || high_ends_i) begin
      expired_q <= !period_ends_i;
      if (high_ends_i)                    pwm_o <= 1'b0;
      else if (expired_q || !high_runs_i) pwm_o <= 1'b1;
    end
  end

`ifdef ASSERT_ON
  logic enabled_q;
  always_ff @(posedge clk_i) enabled_q <= rst_ni && enable_i;
`endif

  `ASSERT(LowWhileDisabled, !pwm_o || enabled_q)

  `COVER(Rises, enable_i && period_ends_i && !high_ends_i && (expired_q || !high_runs_i))
  `COVER(Falls, enable_i && high_ends_i && pwm_o)
  `COVER(ClearBeatsSet, enable_i && period_ends_i && high_ends_i)
  `COVER(StaysAsItIs, enable_i && period_ends_i && !high_ends_i && !expired_q && high_runs_i)

endmodule
