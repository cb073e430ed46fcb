// Core of pulse_width: six of Vo's pulse generators that start together on the trigger, with stop, snapshot and pin
// synchronisers. It has no bus port. Axis i is bit i of every mask and element i of every flat array.
//
// After a stop an axis emits no pulse until its width is written again. A width from before the stop stays in its
// register, because no trigger clears it, and must not start the arm when the stop is cleared.
`include "assert.svh"
`include "pulse_width_reg_types.svh"

module pulse_width_core #(
  parameter logic signed [31:0] EmittedReset = 0  // initial value of the pulse counters, for tests of their wrap-around
) (
  input  logic       clk_i,
  input  logic       rst_ni,       // synchronous
  input  logic       clk_gated_i,  // of all flops but pulses, time and synchronisers
  output logic       active_o,     // clock request; 0: without an access no flop of clk_gated_i changes
  input  logic       trigger_i,    // one cycle per tick

  // Pins.
  input  logic       estop_ni,
  input  logic [5:0] home_i,
  input  logic [5:0] limit_pos_i,
  input  logic [5:0] limit_neg_i,
  input  logic [5:0] drive_alarm_i,
  input  logic [5:0] in_position_i,
  output logic [5:0] step_o,
  output logic [5:0] dir_o,
  output logic [5:0] servo_on_o,
  output logic       heartbeat_o,

  /* verilator tracing_off */
  input  pulse_width_reg2hw_t reg2hw_i,
  output pulse_width_hw2reg_t hw2reg_o
  /* verilator tracing_on */
);

  localparam int Axes = 6;

  logic               stopped, estop, estop_set;
  logic [31:0]        now_q;    // cycles since reset, wraps
  logic [Axes-1:0]    armed_q;  // the width was written since reset and since the last stop
  logic [Axes-1:0]    servo_on, width_we;
  logic [Axes*32-1:0] width;
  assign hw2reg_o.status_estop    = estop;
  assign hw2reg_o.fault_estop_set = estop_set;
  assign hw2reg_o.time_cycles     = now_q;
  assign hw2reg_o.status_armed    = armed_q;
  assign servo_on                 = reg2hw_i.ctrl_servo_on;
  assign width                    = reg2hw_i.width_value;
  assign width_we                 = reg2hw_i.width_we;

  // The paper has no commit, so there is no underrun and the watchdog never acts. A width stays valid, so a set is
  // always pending and the heartbeat inverts with each trigger outside a stop.
  logic       watchdog, watchdog_event, underrun_event;
  logic [7:0]  in_a_row, idle_ticks;
  logic [31:0] underruns;

  stop_control u_stop (
    .clk_i,
    .rst_ni,
    .clk_gated_i,
    .awake_o         (active_o),
    .now_i           (now_q[11:0]),
    .estop_ni,
    .stop_i          (reg2hw_i.estop_stop),
    .clear_estop_i   (reg2hw_i.estop_clear_estop),
    .clear_watchdog_i(1'b0),
    .trigger_i,
    .run_i           (1'b0),
    .pending_i       (1'b1),
    .limit_i         (8'd0),
    .tick_cycles_i   (12'd0),
    .active_o        (stopped),
    .estop_pin_o     (hw2reg_o.status_estop_pin),
    .estop_o         (estop),
    .watchdog_o      (watchdog),
    .heartbeat_o,
    .in_a_row_o      (in_a_row),
    .idle_ticks_o    (idle_ticks),
    .underruns_o     (underruns),
    .estop_event_o   (estop_set),
    .watchdog_event_o(watchdog_event),
    .underrun_event_o(underrun_event)
  );

  logic unused;
  assign unused = ^{watchdog, watchdog_event, underrun_event, in_a_row, idle_ticks, underruns};

  always_ff @(posedge clk_gated_i) begin
    if (!rst_ni || stopped) armed_q <= '0;
    else if (width_we != '0) armed_q <= armed_q | width_we;
  end

  logic signed [31:0] emitted [Axes];  // present values

  for (genvar i = 0; i < Axes; i++) begin : gen_axis
    pulse_width_gen #(.EmittedReset(EmittedReset)) u_gen (
      .clk_i,
      .rst_ni,
      .trigger_i,
      .width_i  (armed_q[i] ? width[i*32 +: 32] : 32'd0),
      .stop_i   (stopped),
      .step_o   (step_o[i]),
      .dir_o    (dir_o[i]),
      .emitted_o(emitted[i])
    );
  end

  logic [Axes*32-1:0] emitted_q;  // snapshot of the last trigger
  assign hw2reg_o.emitted_value = emitted_q;

  // Temporary of the clocked process, written before it is read; evaluated only at a trigger.
  logic [Axes*32-1:0] emitted_now;

  /* verilator lint_off BLKSEQ */
  always_ff @(posedge clk_gated_i) begin
    if (!rst_ni) begin
      emitted_q <= {Axes{EmittedReset}};
    end else if (trigger_i) begin
      for (int i = 0; i < Axes; i++) emitted_now[i*32 +: 32] = emitted[i];
      emitted_q <= emitted_now;
    end
  end
  /* verilator lint_on BLKSEQ */

  event_time #(.Events(1)) u_fault_time (
    .clk_i  (clk_gated_i),
    .rst_ni,
    .now_i  (now_q),
    .event_i(estop_set),
    .flag_i (reg2hw_i.fault_estop),
    .time_o (hw2reg_o.fault_time_cycles)
  );

  logic [Axes-1:0] home, limit_pos, limit_neg, drive_alarm, in_position;
  assign hw2reg_o.switches_home      = home;
  assign hw2reg_o.switches_limit_pos = limit_pos;
  assign hw2reg_o.switches_limit_neg = limit_neg;
  assign hw2reg_o.drives_alarm       = drive_alarm;
  assign hw2reg_o.drives_in_position = in_position;
  assign hw2reg_o.drives_servo_on    = servo_on_o;

  sync_2ff #(.Width(5*Axes)) u_sync (
    .clk_i,
    .rst_ni,
    .async_i({home_i, limit_pos_i, limit_neg_i, drive_alarm_i, in_position_i}),
    .level_o({home, limit_pos, limit_neg, drive_alarm, in_position})
  );

  always_ff @(posedge clk_i) begin
    if (!rst_ni) now_q <= '0;
    else         now_q <= now_q + 32'd1;
  end

  always_ff @(posedge clk_gated_i) begin
    if (!rst_ni) servo_on_o <= '0;
    else         servo_on_o <= estop ? '0 : servo_on;
  end

`ifdef ASSERT_ON
  logic            latched_before_q;
  logic [Axes-1:0] step_before_q;

  always_ff @(posedge clk_i) begin
    latched_before_q <= rst_ni && estop;
    step_before_q    <= step_o;
  end

  `ASSERT(NoRiseWhileLatched, !latched_before_q || (step_o & ~step_before_q) == '0)
  `ASSERT(NoServoWhileLatched, !latched_before_q || servo_on_o == '0)
  `ASSERT(NothingArmedWhileLatched, !latched_before_q || armed_q == '0)
`endif

  `COVER(EstopRaised, estop_set && !reg2hw_i.fault_estop)
  `COVER(EstopDisarms, stopped && armed_q != '0)

endmodule
