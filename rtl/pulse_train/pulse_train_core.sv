// Six pulse generators that start together on the trigger, with everything around them that keeps the counts truthful:
// commit, stops, snapshots and faults. It never sees the bus; ports are named as the registers they serve.
//
// Axis i is bit i of every mask and element i of every flat array. In every tick and for every axis
//   count that became active = change of EMITTED + change of RESIDUAL.
`include "assert.svh"

module pulse_train_core #(
  parameter int                 Axes         = 6,
  parameter logic signed [31:0] EmittedReset = 0  // start value of the pulse counters, for tests of their wrap
) (
  input  logic               clk_i,
  input  logic               rst_ni,            // synchronous
  input  logic               trigger_i,         // one cycle per tick

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

  // Settings.
  input  logic [Axes-1:0]    servo_on_i,
  input  logic               run_i,
  input  logic [7:0]         watchdog_limit_i,  // underruns in a row
  input  logic [11:0]        tick_cycles_i,
  input  logic [9:0]         dir_setup_i,       // cycles
  input  logic [9:0]         dir_hold_i,        // cycles

  // Commands, one cycle each.
  input  logic               stop_i,
  input  logic               clear_estop_i,
  input  logic               clear_watchdog_i,
  input  logic               commit_i,
  input  logic [Axes*16-1:0] count_i,           // staged, signed
  input  logic [15:0]        sequence_i,        // of the staged set

  // State.
  output logic               estop_o,           // latched
  output logic               watchdog_o,        // latched
  output logic               estop_pin_o,       // 1: the pin is low
  output logic               pending_o,
  output logic [15:0]        sequence_o,
  output logic [7:0]         in_a_row_o,
  output logic [31:0]        underruns_o,
  output logic [31:0]        time_o,            // cycles since reset, wraps
  output logic [Axes-1:0]    home_o,
  output logic [Axes-1:0]    limit_pos_o,
  output logic [Axes-1:0]    limit_neg_o,
  output logic [Axes-1:0]    drive_alarm_o,
  output logic [Axes-1:0]    in_position_o,
  output logic [Axes*32-1:0] emitted_o,         // snapshot of the last trigger
  output logic [Axes*32-1:0] residual_o,

  // Faults, bit as in the FAULT register.
  output logic [5:0]         fault_set_o,       // one cycle per event; RESIDUAL and CLIPPED one cycle after it
  input  logic [5:0]         fault_i,           // the sticky flags
  output logic [6*32-1:0]    fault_time_o
);

  localparam int FaultEstop    = pulse_train_reg_pkg::FaultEstopLsb;
  localparam int FaultWatchdog = pulse_train_reg_pkg::FaultWatchdogLsb;
  localparam int FaultUnderrun = pulse_train_reg_pkg::FaultUnderrunLsb;
  localparam int FaultResidual = pulse_train_reg_pkg::FaultResidualLsb;
  localparam int FaultClipped  = pulse_train_reg_pkg::FaultClippedLsb;
  localparam int FaultRecommit = pulse_train_reg_pkg::FaultRecommitLsb;

  logic stopped;

  stop_control u_stop (
    .clk_i,
    .rst_ni,
    .estop_ni,
    .stop_i,
    .clear_estop_i,
    .clear_watchdog_i,
    .trigger_i,
    .run_i,
    .pending_i       (pending_o),
    .limit_i         (watchdog_limit_i),
    .active_o        (stopped),
    .estop_pin_o,
    .estop_o,
    .watchdog_o,
    .in_a_row_o,
    .underruns_o,
    .estop_event_o   (fault_set_o[FaultEstop]),
    .watchdog_event_o(fault_set_o[FaultWatchdog]),
    .underrun_event_o(fault_set_o[FaultUnderrun])
  );

  logic [Axes*9-1:0] count;  // of the tick that begins

  commit_bank #(.Axes(Axes)) u_bank (
    .clk_i,
    .rst_ni,
    .trigger_i,
    .commit_i,
    .discard_i        (stopped),
    .staged_i         (count_i),
    .staged_sequence_i(sequence_i),
    .count_o          (count),
    .pending_o,
    .sequence_o,
    .clipped_o        (fault_set_o[FaultClipped]),
    .recommit_o       (fault_set_o[FaultRecommit])
  );

  logic signed [31:0] emitted    [Axes];  // live
  logic signed [8:0]  unfinished [Axes];  // of the tick that ends

  for (genvar i = 0; i < Axes; i++) begin : gen_axis
    pulse_gen #(.EmittedReset(EmittedReset)) u_gen (
      .clk_i,
      .rst_ni,
      .trigger_i,
      .count_i      (count[i*9 +: 9]),
      .stop_i       (stopped),
      .tick_cycles_i,
      .dir_setup_i,
      .dir_hold_i,
      .step_o       (step_o[i]),
      .dir_o        (dir_o[i]),
      .emitted_o    (emitted[i]),
      .unfinished_o (unfinished[i])
    );
  end

  logic residual_event_q;  // one cycle, after the trigger that found unfinished pulses
  assign fault_set_o[FaultResidual] = residual_event_q;

  // Scratch of the clocked process, written before it is read; evaluated only at a trigger.
  logic [Axes*32-1:0] emitted_now, residual_now;
  logic               any_unfinished;

  /* verilator lint_off BLKSEQ */
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      emitted_o        <= {Axes{EmittedReset}};
      residual_o       <= '0;
      residual_event_q <= 1'b0;
    end else if (trigger_i) begin
      any_unfinished = 1'b0;
      for (int i = 0; i < Axes; i++) begin
        emitted_now[i*32 +: 32]  = emitted[i];
        residual_now[i*32 +: 32] = residual_o[i*32 +: 32] + 32'(unfinished[i]);
        any_unfinished           = any_unfinished || unfinished[i] != '0;
      end
      emitted_o        <= emitted_now;
      residual_o       <= residual_now;
      residual_event_q <= any_unfinished;
    end else if (residual_event_q) begin
      residual_event_q <= 1'b0;
    end
  end
  /* verilator lint_on BLKSEQ */

  event_time #(.Events(6)) u_fault_time (
    .clk_i,
    .rst_ni,
    .now_i  (time_o),
    .event_i(fault_set_o),
    .flag_i (fault_i),
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
      servo_on_o <= (estop_o || watchdog_o) ? '0 : servo_on_i;
      time_o     <= time_o + 32'd1;
    end
  end

`ifdef ASSERT_ON
  logic            latched_before_q;
  logic [Axes-1:0] step_before_q;

  always_ff @(posedge clk_i) begin
    latched_before_q <= rst_ni && (estop_o || watchdog_o);
    step_before_q    <= step_o;
  end

  `ASSERT(NoRiseWhileLatched, !latched_before_q || (step_o & ~step_before_q) == '0)
  `ASSERT(NoServoWhileLatched, !latched_before_q || servo_on_o == '0)
`endif

  // Every fault flag.
  `COVER(EstopRaised, fault_set_o[FaultEstop] && !fault_i[FaultEstop])
  `COVER(WatchdogRaised, fault_set_o[FaultWatchdog] && !fault_i[FaultWatchdog])
  `COVER(UnderrunRaised, fault_set_o[FaultUnderrun] && !fault_i[FaultUnderrun])
  `COVER(ResidualRaised, fault_set_o[FaultResidual] && !fault_i[FaultResidual])
  `COVER(ClippedRaised, fault_set_o[FaultClipped] && !fault_i[FaultClipped])
  `COVER(RecommitRaised, fault_set_o[FaultRecommit] && !fault_i[FaultRecommit])

endmodule
