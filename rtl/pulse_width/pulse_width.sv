// Six of Vo's pulse generators behind an AXI4-Lite port: bus, register file and core, wiring only. Pins as pulse_train.
// Registers: pulse_width_regs.toml.
module pulse_width #(
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

  logic [5:0]      servo_on, armed, home, limit_pos, limit_neg, drive_alarm, in_position, width_we;
  logic            stop, clear_estop, estop, estop_pin, fault_estop, fault_estop_set;
  logic [31:0]     now, fault_time;
  logic [6*32-1:0] width, emitted;

  pulse_width_reg_top u_regs (
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
    .ctrl_servo_on_o     (servo_on),
    .status_estop_i      (estop),
    .status_estop_pin_i  (estop_pin),
    .status_armed_i      (armed),
    .estop_stop_o        (stop),
    .estop_clear_estop_o (clear_estop),
    .fault_estop_set_i   (fault_estop_set),
    .fault_estop_o       (fault_estop),
    .time_cycles_i       (now),
    .switches_home_i     (home),
    .switches_limit_pos_i(limit_pos),
    .switches_limit_neg_i(limit_neg),
    .drives_alarm_i      (drive_alarm),
    .drives_in_position_i(in_position),
    .width_value_o       (width),
    .width_we_o          (width_we),
    .emitted_value_i     (emitted),
    .fault_time_cycles_i (fault_time)
  );

  pulse_width_core #(.EmittedReset(EmittedReset)) u_core (
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
    .servo_on_i   (servo_on),
    .width_i      (width),
    .width_we_i   (width_we),
    .stop_i       (stop),
    .clear_estop_i(clear_estop),
    .estop_o      (estop),
    .estop_pin_o  (estop_pin),
    .armed_o      (armed),
    .time_o       (now),
    .home_o       (home),
    .limit_pos_o  (limit_pos),
    .limit_neg_o  (limit_neg),
    .drive_alarm_o(drive_alarm),
    .in_position_o(in_position),
    .emitted_o    (emitted),
    .estop_set_o  (fault_estop_set),
    .estop_flag_i (fault_estop),
    .fault_time_o (fault_time)
  );

endmodule
