// AXI GPIO v2.0 compatible block, two channels of 16 pins: bus, register file and core. Registers: axi_gpio_regs.toml.
`include "axi_lite_types.svh"
`include "axi_gpio_reg_types.svh"

module axi_gpio #(
  // The vendor's C_ALL_INPUTS, C_ALL_OUTPUTS, C_DOUT_DEFAULT and C_TRI_DEFAULT of channel 1, then of channel 2.
  parameter bit          AllInputs    = 1'b0,
  parameter bit          AllOutputs   = 1'b0,
  parameter logic [15:0] DoutDefault  = 16'h0000,
  parameter logic [15:0] TriDefault   = 16'hFFFF,
  parameter bit          AllInputs2   = 1'b0,
  parameter bit          AllOutputs2  = 1'b0,
  parameter logic [15:0] DoutDefault2 = 16'h0000,
  parameter logic [15:0] TriDefault2  = 16'hFFFF
) (
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

  // Channel 1. Inputs are asynchronous and are synchronised here. Outputs are flops.
  input  logic [15:0]   gpio_i,         // levels of the pads
  output logic [15:0]   gpio_o,         // written levels, for pads with a tri-state buffer
  output logic [15:0]   gpio_t_o,       // 1: the buffer releases its pad
  output logic [15:0]   gpio_driven_o,  // for pads without a tri-state buffer: gpio_o, and 0 where it is released
  // Channel 2.
  input  logic [15:0]   gpio2_i,
  output logic [15:0]   gpio2_o,
  output logic [15:0]   gpio2_t_o,

  output logic          irq_o           // level, active high, from a flop
);

  /* verilator tracing_off */
  reg_req_t access;
  reg_rsp_t answer;
  axi_gpio_reg2hw_t reg2hw;
  axi_gpio_hw2reg_t hw2reg;
  /* verilator tracing_on */

  // While the block is idle, only the synchronisers need a clock.
  logic bus_active, core_awake;
  assign active_o = bus_active || core_awake;

  logic [15:0] inputs, inputs2;
  sync_2ff #(.Width(32)) u_sync (.clk_i, .rst_ni, .async_i({gpio2_i, gpio_i}), .level_o({inputs2, inputs}));

  axi_lite_slave u_bus (
    .clk_i(clk_gated_i), .rst_ni, .active_o(bus_active), .s_axi_i, .s_axi_o, .reg_o(access), .reg_i(answer)
  );

  axi_gpio_reg_top u_regs (
    .clk_i(clk_gated_i), .rst_ni, .reg_i(access), .reg_o(answer), .reg2hw_o(reg2hw), .hw2reg_i(hw2reg)
  );

  axi_gpio_core #(
    .AllInputs(AllInputs), .AllOutputs(AllOutputs), .DoutDefault(DoutDefault), .TriDefault(TriDefault),
    .AllInputs2(AllInputs2), .AllOutputs2(AllOutputs2), .DoutDefault2(DoutDefault2), .TriDefault2(TriDefault2)
  ) u_core (
    .clk_i(clk_gated_i), .rst_ni, .gpio_i(inputs), .gpio_o, .gpio_t_o, .gpio_driven_o, .gpio2_i(inputs2), .gpio2_o,
    .gpio2_t_o, .irq_o, .awake_o(core_awake), .reg2hw_i(reg2hw), .hw2reg_o(hw2reg)
  );

endmodule
