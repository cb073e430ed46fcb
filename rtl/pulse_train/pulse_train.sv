// Six pulse-and-direction generators with an AXI4-Lite port. Wiring of bus, register file and core only.
// Registers: pulse_train_regs.toml.
`include "axi_lite_types.svh"
`include "pulse_train_reg_types.svh"

module pulse_train #(
  parameter logic signed [31:0] EmittedReset   = 0,  // initial value of the pulse counters, for tests of their wrap
  parameter logic        [31:0] UnderrunsReset = 0   // initial value of UNDERRUNS, for tests of its largest value
) (
  input  logic          clk_i,
  input  logic          rst_ni,         // synchronous

  input  logic          clk_gated_i,    // of all flops but pulses, time and synchronisers
  output logic          active_o,       // clock request; 0: the next edge changes no flop of clk_gated_i

  /* verilator tracing_off */
  input  axi_lite_req_t s_axi_i,
  output axi_lite_rsp_t s_axi_o,
  /* verilator tracing_on */

  input  logic          trigger_i,      // one cycle per tick: the committed counts become active

  // Pins, one bit per axis.
  input  logic          estop_ni,       // asynchronous, active low: emergency stop
  input  logic [5:0]    home_i,         // asynchronous
  input  logic [5:0]    limit_pos_i,    // asynchronous
  input  logic [5:0]    limit_neg_i,    // asynchronous
  input  logic [5:0]    drive_alarm_i,  // asynchronous
  input  logic [5:0]    in_position_i,  // asynchronous
  output logic [5:0]    step_o,         // all outputs are flops; a rising edge is one pulse
  output logic [5:0]    dir_o,          // 1: positive
  output logic [5:0]    servo_on_o,     // drive enable, 0 while a stop is latched
  output logic          heartbeat_o     // inverts with each set of counts that becomes active
);

  /* verilator tracing_off */
  reg_req_t access;
  reg_rsp_t answer;
  pulse_train_reg2hw_t reg2hw;
  pulse_train_hw2reg_t hw2reg;
  /* verilator tracing_on */

  logic bus_active, core_active;
  assign active_o = bus_active || core_active;

  axi_lite_slave u_bus (
    .clk_i(clk_gated_i), .rst_ni, .active_o(bus_active), .s_axi_i, .s_axi_o, .reg_o(access), .reg_i(answer)
  );

  pulse_train_reg_top u_regs (
    .clk_i(clk_gated_i), .rst_ni, .protect_i(|servo_on_o), .reg_i(access), .reg_o(answer), .reg2hw_o(reg2hw),
    .hw2reg_i(hw2reg)
  );

  pulse_train_core #(.EmittedReset(EmittedReset), .UnderrunsReset(UnderrunsReset)) u_core (
    .clk_i, .rst_ni, .clk_gated_i, .active_o(core_active), .trigger_i, .estop_ni, .home_i, .limit_pos_i, .limit_neg_i,
    .drive_alarm_i, .in_position_i, .step_o, .dir_o, .servo_on_o, .heartbeat_o, .reg2hw_i(reg2hw), .hw2reg_o(hw2reg)
  );

endmodule
