// Six pulse-and-direction generators behind an AXI4-Lite port: bus, register file and core, wiring only.
// Registers: pulse_train_regs.toml.
module pulse_train #(
  parameter logic signed [31:0] EmittedReset = 0  // start value of the pulse counters, for tests of their wrap
) (
  input  logic        clk_i,
  input  logic        rst_ni,  // synchronous

  input  logic [15:0] s_axi_awaddr_i,
  input  logic        s_axi_awvalid_i,
  output logic        s_axi_awready_o,
  input  logic [31:0] s_axi_wdata_i,
  input  logic [3:0]  s_axi_wstrb_i,
  input  logic        s_axi_wvalid_i,
  output logic        s_axi_wready_o,
  output logic [1:0]  s_axi_bresp_o,
  output logic        s_axi_bvalid_o,
  input  logic        s_axi_bready_i,
  input  logic [15:0] s_axi_araddr_i,
  input  logic        s_axi_arvalid_i,
  output logic        s_axi_arready_o,
  output logic [31:0] s_axi_rdata_o,
  output logic [1:0]  s_axi_rresp_o,
  output logic        s_axi_rvalid_o,
  input  logic        s_axi_rready_i,

  input  logic        trigger_i,      // one cycle per tick

  // Pins, one bit per axis.
  input  logic        estop_ni,       // asynchronous, low: stop
  input  logic [5:0]  home_i,         // asynchronous
  input  logic [5:0]  limit_pos_i,    // asynchronous
  input  logic [5:0]  limit_neg_i,    // asynchronous
  input  logic [5:0]  drive_alarm_i,  // asynchronous
  input  logic [5:0]  in_position_i,  // asynchronous
  output logic [5:0]  step_o,         // all outputs from flops
  output logic [5:0]  dir_o,          // 1: positive
  output logic [5:0]  servo_on_o
);

  logic        reg_we, reg_werr, reg_re, reg_rerr;
  logic [15:0] reg_waddr, reg_raddr;
  logic [31:0] reg_wdata, reg_rdata;
  logic [3:0]  reg_wstrb;

  axi_lite_slave #(.AddrWidth(16)) u_bus (
    .clk_i,
    .rst_ni,
    .s_axi_awaddr_i,
    .s_axi_awvalid_i,
    .s_axi_awready_o,
    .s_axi_wdata_i,
    .s_axi_wstrb_i,
    .s_axi_wvalid_i,
    .s_axi_wready_o,
    .s_axi_bresp_o,
    .s_axi_bvalid_o,
    .s_axi_bready_i,
    .s_axi_araddr_i,
    .s_axi_arvalid_i,
    .s_axi_arready_o,
    .s_axi_rdata_o,
    .s_axi_rresp_o,
    .s_axi_rvalid_o,
    .s_axi_rready_i,
    .reg_we_o   (reg_we),
    .reg_waddr_o(reg_waddr),
    .reg_wdata_o(reg_wdata),
    .reg_wstrb_o(reg_wstrb),
    .reg_werr_i (reg_werr),
    .reg_re_o   (reg_re),
    .reg_raddr_o(reg_raddr),
    .reg_rdata_i(reg_rdata),
    .reg_rerr_i (reg_rerr)
  );

  logic [5:0]      servo_on, home, limit_pos, limit_neg, drive_alarm, in_position, fault, fault_set;
  logic            run, stop, clear_estop, clear_watchdog, commit, estop, watchdog, estop_pin, pending;
  logic [15:0]     sequence_committed, sequence_active;
  logic [7:0]      watchdog_limit, in_a_row;
  logic [31:0]     underruns, now;
  logic [11:0]     tick_cycles;
  logic [9:0]      dir_setup, dir_hold;
  logic [6*16-1:0] count;
  logic [6*32-1:0] emitted, residual, fault_time;

  localparam int FaultEstop    = pulse_train_reg_pkg::FaultEstopLsb;
  localparam int FaultWatchdog = pulse_train_reg_pkg::FaultWatchdogLsb;
  localparam int FaultUnderrun = pulse_train_reg_pkg::FaultUnderrunLsb;
  localparam int FaultResidual = pulse_train_reg_pkg::FaultResidualLsb;
  localparam int FaultClipped  = pulse_train_reg_pkg::FaultClippedLsb;
  localparam int FaultRecommit = pulse_train_reg_pkg::FaultRecommitLsb;

  pulse_train_reg_top u_regs (
    .clk_i,
    .rst_ni,
    .reg_we_i   (reg_we),
    .reg_waddr_i(reg_waddr),
    .reg_wdata_i(reg_wdata),
    .reg_wstrb_i(reg_wstrb),
    .reg_werr_o (reg_werr),
    .reg_re_i   (reg_re),
    .reg_raddr_i(reg_raddr),
    .reg_rdata_o(reg_rdata),
    .reg_rerr_o (reg_rerr),
    .ctrl_servo_on_o       (servo_on),
    .ctrl_run_o            (run),
    .status_estop_i        (estop),
    .status_watchdog_i     (watchdog),
    .status_estop_pin_i    (estop_pin),
    .status_pending_i      (pending),
    .status_sequence_i     (sequence_active),
    .estop_stop_o          (stop),
    .estop_clear_estop_o   (clear_estop),
    .estop_clear_watchdog_o(clear_watchdog),
    .fault_estop_set_i     (fault_set[FaultEstop]),
    .fault_estop_o         (fault[FaultEstop]),
    .fault_watchdog_set_i  (fault_set[FaultWatchdog]),
    .fault_watchdog_o      (fault[FaultWatchdog]),
    .fault_underrun_set_i  (fault_set[FaultUnderrun]),
    .fault_underrun_o      (fault[FaultUnderrun]),
    .fault_residual_set_i  (fault_set[FaultResidual]),
    .fault_residual_o      (fault[FaultResidual]),
    .fault_clipped_set_i   (fault_set[FaultClipped]),
    .fault_clipped_o       (fault[FaultClipped]),
    .fault_recommit_set_i  (fault_set[FaultRecommit]),
    .fault_recommit_o      (fault[FaultRecommit]),
    .watchdog_limit_o      (watchdog_limit),
    .watchdog_in_a_row_i   (in_a_row),
    .underruns_total_i     (underruns),
    .tick_cycles_value_o   (tick_cycles),
    .dir_setup_value_o     (dir_setup),
    .dir_hold_value_o      (dir_hold),
    .commit_sequence_o     (sequence_committed),
    .commit_we_o           (commit),
    .time_cycles_i         (now),
    .switches_home_i       (home),
    .switches_limit_pos_i  (limit_pos),
    .switches_limit_neg_i  (limit_neg),
    .drives_alarm_i        (drive_alarm),
    .drives_in_position_i  (in_position),
    .count_value_o         (count),
    .emitted_value_i       (emitted),
    .residual_value_i      (residual),
    .fault_time_cycles_i   (fault_time)
  );

  pulse_train_core #(.EmittedReset(EmittedReset)) u_core (
    .clk_i,
    .rst_ni,
    .trigger_i,
    .estop_ni,
    .home_i,
    .limit_pos_i,
    .limit_neg_i,
    .drive_alarm_i,
    .in_position_i,
    .step_o,
    .dir_o,
    .servo_on_o,
    .servo_on_i      (servo_on),
    .run_i           (run),
    .watchdog_limit_i(watchdog_limit),
    .tick_cycles_i   (tick_cycles),
    .dir_setup_i     (dir_setup),
    .dir_hold_i      (dir_hold),
    .stop_i          (stop),
    .clear_estop_i   (clear_estop),
    .clear_watchdog_i(clear_watchdog),
    .commit_i        (commit),
    .count_i         (count),
    .sequence_i      (sequence_committed),
    .estop_o         (estop),
    .watchdog_o      (watchdog),
    .estop_pin_o     (estop_pin),
    .pending_o       (pending),
    .sequence_o      (sequence_active),
    .in_a_row_o      (in_a_row),
    .underruns_o     (underruns),
    .time_o          (now),
    .home_o          (home),
    .limit_pos_o     (limit_pos),
    .limit_neg_o     (limit_neg),
    .drive_alarm_o   (drive_alarm),
    .in_position_o   (in_position),
    .emitted_o       (emitted),
    .residual_o      (residual),
    .fault_set_o     (fault_set),
    .fault_i         (fault),
    .fault_time_o    (fault_time)
  );

endmodule
