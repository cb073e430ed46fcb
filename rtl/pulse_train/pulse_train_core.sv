// Core of pulse_train: six pulse generators that start together on the trigger, with commit, stops, snapshots and
// faults. It has no bus port.
//
// Axis i is bit i of every mask and element i of every flat array. In every tick and for every axis
//   count that became active = change of EMITTED + change of RESIDUAL.
`include "assert.svh"
`include "pulse_train_reg_types.svh"

module pulse_train_core #(
  parameter logic signed [31:0] EmittedReset   = 0,  // initial value of the pulse counters, for tests of their wrap
  parameter logic        [31:0] UnderrunsReset = 0   // initial value of UNDERRUNS, for tests of its largest value
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
  input  pulse_train_reg2hw_t reg2hw_i,
  output pulse_train_hw2reg_t hw2reg_o
  /* verilator tracing_on */
);

  localparam int Axes = 6;

  localparam int FaultEstop    = pulse_train_reg_pkg::FaultEstopLsb;
  localparam int FaultWatchdog = pulse_train_reg_pkg::FaultWatchdogLsb;
  localparam int FaultUnderrun = pulse_train_reg_pkg::FaultUnderrunLsb;
  localparam int FaultResidual = pulse_train_reg_pkg::FaultResidualLsb;
  localparam int FaultClipped  = pulse_train_reg_pkg::FaultClippedLsb;
  localparam int FaultRecommit = pulse_train_reg_pkg::FaultRecommitLsb;

  // One cycle per event, bits as in the FAULT register. RESIDUAL and CLIPPED come one cycle after their event.
  logic [5:0] fault_set, fault;
  assign fault[FaultEstop]            = reg2hw_i.fault_estop;
  assign fault[FaultWatchdog]         = reg2hw_i.fault_watchdog;
  assign fault[FaultUnderrun]         = reg2hw_i.fault_underrun;
  assign fault[FaultResidual]         = reg2hw_i.fault_residual;
  assign fault[FaultClipped]          = reg2hw_i.fault_clipped;
  assign fault[FaultRecommit]         = reg2hw_i.fault_recommit;
  assign hw2reg_o.fault_estop_set     = fault_set[FaultEstop];
  assign hw2reg_o.fault_watchdog_set  = fault_set[FaultWatchdog];
  assign hw2reg_o.fault_underrun_set  = fault_set[FaultUnderrun];
  assign hw2reg_o.fault_residual_set  = fault_set[FaultResidual];
  assign hw2reg_o.fault_clipped_set   = fault_set[FaultClipped];
  assign hw2reg_o.fault_recommit_set  = fault_set[FaultRecommit];

  logic            stopped, estop, watchdog, pending;
  logic [31:0]     now_q;  // cycles since reset, wraps
  logic [Axes-1:0] servo_on;
  assign hw2reg_o.status_estop    = estop;
  assign hw2reg_o.status_watchdog = watchdog;
  assign hw2reg_o.status_pending  = pending;
  assign hw2reg_o.time_cycles     = now_q;
  assign servo_on                 = reg2hw_i.ctrl_servo_on;

  stop_control #(.UnderrunsReset(UnderrunsReset)) u_stop (
    .clk_i,
    .rst_ni,
    .clk_gated_i,
    .awake_o         (active_o),
    .now_i           (now_q[11:0]),
    .estop_ni,
    .stop_i          (reg2hw_i.estop_stop),
    .clear_estop_i   (reg2hw_i.estop_clear_estop),
    .clear_watchdog_i(reg2hw_i.estop_clear_watchdog),
    .trigger_i,
    .run_i           (reg2hw_i.ctrl_run),
    .pending_i       (pending),
    .limit_i         (reg2hw_i.watchdog_limit),
    .tick_cycles_i   (reg2hw_i.tick_cycles_value),
    .active_o        (stopped),
    .estop_pin_o     (hw2reg_o.status_estop_pin),
    .estop_o         (estop),
    .watchdog_o      (watchdog),
    .heartbeat_o,
    .in_a_row_o      (hw2reg_o.watchdog_in_a_row),
    .idle_ticks_o    (hw2reg_o.watchdog_idle_ticks),
    .underruns_o     (hw2reg_o.underruns_total),
    .estop_event_o   (fault_set[FaultEstop]),
    .watchdog_event_o(fault_set[FaultWatchdog]),
    .underrun_event_o(fault_set[FaultUnderrun])
  );

  logic [Axes*9-1:0] count;  // of the tick that begins; valid in the trigger cycle

  commit_bank #(.Axes(Axes)) u_bank (
    .clk_i            (clk_gated_i),
    .rst_ni,
    .trigger_i,
    .commit_i         (reg2hw_i.commit_we),
    .discard_i        (stopped),
    .staged_i         (reg2hw_i.count_value),
    .staged_sequence_i(reg2hw_i.commit_sequence),
    .count_o          (count),
    .pending_o        (pending),
    .sequence_o       (hw2reg_o.status_sequence),
    .clipped_o        (fault_set[FaultClipped]),
    .recommit_o       (fault_set[FaultRecommit])
  );

  logic signed [31:0] emitted    [Axes];  // present values
  logic signed [8:0]  unfinished [Axes];  // of the tick that ends; valid in the trigger cycle

  for (genvar i = 0; i < Axes; i++) begin : gen_axis
    pulse_gen #(.EmittedReset(EmittedReset)) u_gen (
      .clk_i,
      .rst_ni,
      .trigger_i,
      .count_i      (count[i*9 +: 9]),
      .stop_i       (stopped),
      .tick_cycles_i(reg2hw_i.tick_cycles_value),
      .dir_setup_i  (reg2hw_i.dir_setup_value),
      .dir_hold_i   (reg2hw_i.dir_hold_value),
      .step_o       (step_o[i]),
      .dir_o        (dir_o[i]),
      .emitted_o    (emitted[i]),
      .unfinished_o (unfinished[i])
    );
  end

  logic residual_event_q;  // one cycle, after a trigger with unfinished pulses
  assign fault_set[FaultResidual] = residual_event_q;

  logic [Axes*32-1:0] emitted_q, residual_q;  // snapshots of the last trigger
  assign hw2reg_o.emitted_value  = emitted_q;
  assign hw2reg_o.residual_value = residual_q;

  // Temporaries of the clocked process, written before they are read; evaluated only at a trigger.
  logic [Axes*32-1:0] emitted_now, residual_now;
  logic               any_unfinished;

  /* verilator lint_off BLKSEQ */
  always_ff @(posedge clk_gated_i) begin
    if (!rst_ni) begin
      emitted_q        <= {Axes{EmittedReset}};
      residual_q       <= '0;
      residual_event_q <= 1'b0;
    end else if (trigger_i) begin
      any_unfinished = 1'b0;
      for (int i = 0; i < Axes; i++) begin
        emitted_now[i*32 +: 32]  = emitted[i];
        residual_now[i*32 +: 32] = residual_q[i*32 +: 32] + 32'(unfinished[i]);
        any_unfinished           = any_unfinished || unfinished[i] != '0;
      end
      emitted_q        <= emitted_now;
      residual_q       <= residual_now;
      residual_event_q <= any_unfinished;
    end else if (residual_event_q) begin
      residual_event_q <= 1'b0;
    end
  end
  /* verilator lint_on BLKSEQ */

  event_time #(.Events(6)) u_fault_time (
    .clk_i  (clk_gated_i),
    .rst_ni,
    .now_i  (now_q),
    .event_i(fault_set),
    .flag_i (fault),
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
    else         servo_on_o <= (estop || watchdog) ? '0 : servo_on;
  end

`ifdef ASSERT_ON
  logic            latched_before_q;
  logic [Axes-1:0] step_before_q;

  always_ff @(posedge clk_i) begin
    latched_before_q <= rst_ni && (estop || watchdog);
    step_before_q    <= step_o;
  end

  `ASSERT(NoRiseWhileLatched, !latched_before_q || (step_o & ~step_before_q) == '0)
  `ASSERT(NoServoWhileLatched, !latched_before_q || servo_on_o == '0)
`endif

  // Every fault flag.
  `COVER(EstopRaised, fault_set[FaultEstop] && !fault[FaultEstop])
  `COVER(WatchdogRaised, fault_set[FaultWatchdog] && !fault[FaultWatchdog])
  `COVER(UnderrunRaised, fault_set[FaultUnderrun] && !fault[FaultUnderrun])
  `COVER(ResidualRaised, fault_set[FaultResidual] && !fault[FaultResidual])
  `COVER(ClippedRaised, fault_set[FaultClipped] && !fault[FaultClipped])
  `COVER(RecommitRaised, fault_set[FaultRecommit] && !fault[FaultRecommit])

endmodule
