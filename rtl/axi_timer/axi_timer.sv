// AXI Timer v2.0 compatible block: two 32-bit timers, or one of 64 bits, or a PWM output; one interrupt line.
//
// The end of a period sets the flag of its timer and its generate_o in the same clock; irq_o follows one clock later.
`include "axi_lite_types.svh"
`include "axi_timer_reg_types.svh"

module axi_timer #(
  parameter bit Gen0Assert  = 1'b1,  // active levels: GenerateOut of timers 0 and 1, capture pins of timers 0 and 1
  parameter bit Gen1Assert  = 1'b1,
  parameter bit Trig0Assert = 1'b1,
  parameter bit Trig1Assert = 1'b1
) (
  input  logic        clk_i,
  input  logic        rst_ni,       // synchronous

  input  logic        clk_gated_i,  // of all flops but counters and synchronisers
  output logic        active_o,     // clock request; 0: the next edge changes no flop of clk_gated_i

  /* verilator tracing_off */
  input  axi_lite_req_t s_axi_i,
  output axi_lite_rsp_t s_axi_o,
  /* verilator tracing_on */

  input  logic [1:0]  capture_trig_i,  // asynchronous; bit i: timer i. An active edge stores TCR three clocks later
  input  logic        freeze_i,        // asynchronous; 1 stops both counters two clocks later
  output logic [1:0]  generate_o,      // bit i: active for one clock per period of timer i, from a flop
  output logic        pwm_o,           // from a flop
  output logic        irq_o            // level until acknowledged, from a flop
);

  /* verilator tracing_off */
  reg_req_t access;
  reg_rsp_t answer;
  axi_timer_reg2hw_t reg2hw;
  axi_timer_hw2reg_t hw2reg;
  /* verilator tracing_on */

  logic bus_active, core_active;
  assign active_o = bus_active || core_active;

  axi_lite_slave u_bus (
    .clk_i(clk_gated_i), .rst_ni, .active_o(bus_active), .s_axi_i, .s_axi_o, .reg_o(access), .reg_i(answer)
  );

  axi_timer_reg_top u_regs (
    .clk_i(clk_gated_i), .rst_ni, .reg_i(access), .reg_o(answer), .reg2hw_o(reg2hw), .hw2reg_i(hw2reg)
  );

  timer_core #(
    .Gen0Assert(Gen0Assert), .Gen1Assert(Gen1Assert), .Trig0Assert(Trig0Assert), .Trig1Assert(Trig1Assert)
  ) u_core (
    .clk_i, .rst_ni, .clk_gated_i, .active_o(core_active), .reg2hw_i(reg2hw), .hw2reg_o(hw2reg),
    .capture_trig_i, .freeze_i, .generate_o, .pwm_o, .irq_o
  );

endmodule
