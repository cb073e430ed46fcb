// AXI GPIO v2.0 compatible block, 16 outputs and 16 inputs: bus, register file and core. Registers: axi_gpio_regs.toml.
`include "axi_lite_types.svh"
`include "axi_gpio_reg_types.svh"

module axi_gpio (
  input  logic          clk_i,
  input  logic          rst_ni,  // synchronous

  // Clock of everything but the synchronisers: clk_i, or clk_i gated by active_o (no edge after active_o = 0 while
  // rst_ni = 1). No flop would change at the gated edges. Gating saves power in hardware and time in simulation.
  input  logic          clk_gated_i,
  output logic          active_o,  // clock request: the next edge of clk_i is needed

  /* verilator tracing_off */
  input  axi_lite_req_t s_axi_i,
  output axi_lite_rsp_t s_axi_o,
  /* verilator tracing_on */

  input  logic [15:0]   gpio_i,  // channel 2, asynchronous; synchronised here
  output logic [15:0]   gpio_o,  // channel 1, from flops, 0 after reset
  output logic          irq_o    // level, active high, from a flop
);

  /* verilator tracing_off */
  reg_req_t access;
  reg_rsp_t answer;
  axi_gpio_reg2hw_t reg2hw;
  axi_gpio_hw2reg_t hw2reg;
  /* verilator tracing_on */

  // While the block is idle, only the synchroniser needs a clock.
  logic bus_active, core_awake;
  assign active_o = bus_active || core_awake;

  logic [15:0] inputs;
  sync_2ff #(.Width(16)) u_sync (.clk_i, .rst_ni, .async_i(gpio_i), .level_o(inputs));

  axi_lite_slave u_bus (
    .clk_i(clk_gated_i), .rst_ni, .active_o(bus_active), .s_axi_i, .s_axi_o, .reg_o(access), .reg_i(answer)
  );

  axi_gpio_reg_top u_regs (
    .clk_i(clk_gated_i), .rst_ni, .reg_i(access), .reg_o(answer), .reg2hw_o(reg2hw), .hw2reg_i(hw2reg)
  );

  axi_gpio_core u_core (
    .clk_i(clk_gated_i), .rst_ni, .gpio_i(inputs), .gpio_o, .irq_o, .awake_o(core_awake),
    .reg2hw_i(reg2hw), .hw2reg_o(hw2reg)
  );

endmodule
