// Six of Vo's pulse generators that start together on the trigger, with stop, snapshot and pin synchronisers. It never
// sees the bus; ports are named as the registers they serve. Axis i is bit i of every mask and element i of every flat
// array.
//
// An axis that a stop has ended stays still until its width is written again: a width from before the stop, which no
// trigger consumes, must not start the arm when the stop is cleared.
`include "assert.svh"

module pulse_width_core #(
  parameter int                 Axes         = 6,
  parameter logic signed [31:0] EmittedReset = 0  // start value of the pulse counters, for tests of their wrap
) (
  input  logic               clk_i,
  input  logic               rst_ni,         // synchronous
  input  logic               trigger_i,      // one cycle per tick

  // Pins.
  input  logic               estop_ni,
  input  logic [Axes-1:0]    home_i,
  input  logic [Axes-1:0]    limit_pos_i,
  input  logic [Axes-1:0]    limit_neg_i,
  input  logic [Axes-1:0]    drive_alarm_i,
  input  logic [Axes-1:0]    in_position_i,
  output logic [Axes-1:0]    step_o,
  output logic [Axes-1:0]    dir_o,
  output logic [Axes-1:0]    servo_on_o,

  input  logic [Axes-1:0]    servo_on_i,
  input  logic [Axes*32-1:0] width_i,        // signed half periods, cycles
  input  logic [Axes-1:0]    width_we_i,     // one cycle: the width of the axis was written

  // Commands, one cycle each.
  input  logic               stop_i,
  input  logic               clear_estop_i,

  // State.
  output logic               estop_o,        // latched
  output logic               estop_pin_o,    // 1: the pin is low
  output logic [Axes-1:0]    armed_o,        // the width was written since reset and since the last stop
  output logic [31:0]        time_o,         // cycles since reset, wraps
  output logic [Axes-1:0]    home_o,
  output logic [Axes-1:0]    limit_pos_o,
  output logic [Axes-1:0]    limit_neg_o,
  output logic [Axes-1:0]    drive_alarm_o,
  output logic [Axes-1:0]    in_position_o,
  output logic [Axes*32-1:0] emitted_o,      // snapshot of the last trigger

  output logic               estop_set_o,    // one cycle per event
  input  logic               estop_flag_i,   // the sticky flag
  output logic [31:0]        fault_time_o
);

  logic stopped;

  // The paper has no commit, so no trigger is an underrun and the watchdog stays silent.
  logic       watchdog, watchdog_event, underrun_event;
  logic [7:0]  in_a_row;
  logic [31:0] underruns;

  stop_control u_stop (
    .clk_i,
    .rst_ni,
    .estop_ni,
    .stop_i,
    .clear_estop_i,
    .clear_watchdog_i(1'b0),
    .trigger_i,
    .run_i           (1'b0),
    .pending_i       (1'b0),
    .limit_i         (8'd0),
    .active_o        (stopped),
    .estop_pin_o,
    .estop_o,
    .watchdog_o      (watchdog),
    .in_a_row_o      (in_a_row),
    .underruns_o     (underruns),
    .estop_event_o   (estop_set_o),
    .watchdog_event_o(watchdog_event),
    .underrun_event_o(underrun_event)
  );

  logic unused;
  assign unused = ^{watchdog, watchdog_event, underrun_event, in_a_row, underruns};

  always_ff @(posedge clk_i) begin
    if (!rst_ni || stopped) armed_o <= '0;
    else if (width_we_i != '0) armed_o <= armed_o | width_we_i;
  end

  logic signed [31:0] emitted [Axes];  // live

  for (genvar i = 0; i < Axes; i++) begin : gen_axis
    pulse_width_gen #(.EmittedReset(EmittedReset)) u_gen (
      .clk_i,
      .rst_ni,
      .trigger_i,
      .width_i  (armed_o[i] ? width_i[i*32 +: 32] : 32'd0),
      .stop_i   (stopped),
      .step_o   (step_o[i]),
      .dir_o    (dir_o[i]),
      .emitted_o(emitted[i])
    );
  end

  // Scratch of the clocked process, written before it is read; evaluated only at a trigger.
  logic [Axes*32-1:0] emitted_now;

  /* verilator lint_off BLKSEQ */
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      emitted_o <= {Axes{EmittedReset}};
    end else if (trigger_i) begin
      for (int i = 0; i < Axes; i++) emitted_now[i*32 +: 32] = emitted[i];
      emitted_o <= emitted_now;
    end
  end
  /* verilator lint_on BLKSEQ */

  event_time #(.Events(1)) u_fault_time (
    .clk_i,
    .rst_ni,
    .now_i  (time_o),
    .event_i(estop_set_o),
    .flag_i (estop_flag_i),
    .time_o (fault_time_o)
  );

  sync_2ff #(.Width(5*Axes)) u_sync (
    .clk_i,
    .rst_ni,
    .async_i({home_i, limit_pos_i, limit_neg_i, drive_alarm_i, in_position_i}),
    .level_o({home_o, limit_pos_o, limit_neg_o, drive_alarm_o, in_position_o})
  );

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      servo_on_o <= '0;
      time_o     <= '0;
    end else begin
      servo_on_o <= estop_o ? '0 : servo_on_i;
      time_o     <= time_o + 32'd1;
    end
  end

`ifdef ASSERT_ON
  logic            latched_before_q;
  logic [Axes-1:0] step_before_q;

  always_ff @(posedge clk_i) begin
    latched_before_q <= rst_ni && estop_o;
    step_before_q    <= step_o;
  end

  `ASSERT(NoRiseWhileLatched, !latched_before_q || (step_o & ~step_before_q) == '0)
  `ASSERT(NoServoWhileLatched, !latched_before_q || servo_on_o == '0)
  `ASSERT(NothingArmedWhileLatched, !latched_before_q || armed_o == '0)
`endif

  `COVER(EstopRaised, estop_set_o && !estop_flag_i)
  `COVER(EstopDisarms, stopped && armed_o != '0)

endmodule
