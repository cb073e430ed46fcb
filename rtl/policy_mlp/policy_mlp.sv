// Multi-layer perceptron of 8-bit integers with an AXI4-Lite port. Wiring of bus, register file and core only.
// Registers: policy_mlp_regs.toml.
`include "axi_lite_types.svh"
`include "policy_mlp_reg_types.svh"

module policy_mlp #(
  parameter int Lanes = 8  // weights that are multiplied in a clock: 4, 8 or 16
) (
  input  logic          clk_i,     // may be gated by active_o
  input  logic          rst_ni,    // synchronous
  output logic          active_o,  // clock request; 0: the next edge changes no flop

  /* verilator tracing_off */
  input  axi_lite_req_t s_axi_i,
  output axi_lite_rsp_t s_axi_o,
  /* verilator tracing_on */

  output logic          irq_o
);

  /* verilator tracing_off */
  reg_req_t access;
  reg_rsp_t answer;
  policy_mlp_reg2hw_t reg2hw;
  policy_mlp_hw2reg_t hw2reg;
  /* verilator tracing_on */

  logic bus_active, core_active;
  assign active_o = bus_active || core_active;

  axi_lite_slave u_bus (
    .clk_i, .rst_ni, .active_o(bus_active), .s_axi_i, .s_axi_o, .reg_o(access), .reg_i(answer)
  );

  policy_mlp_reg_top u_regs (
    .clk_i, .rst_ni, .reg_i(access), .reg_o(answer), .reg2hw_o(reg2hw), .hw2reg_i(hw2reg)
  );

  policy_core #(.Lanes(Lanes)) u_core (
    .clk_i, .rst_ni, .active_o(core_active), .reg2hw_i(reg2hw), .hw2reg_o(hw2reg), .irq_o
  );

endmodule
