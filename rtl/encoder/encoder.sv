// Debounced quadrature decoders with an AXI4-Lite port. Wiring of bus, register file and core only.
// Registers: encoder_regs.toml.
`include "axi_lite_types.svh"
`include "encoder_reg_types.svh"

module encoder #(
  parameter int                 Axes          = 6,  // 1..6
  parameter logic signed [31:0] PositionReset = 0   // initial position in counts, for tests of the wrap-around
) (
  input  logic            clk_i,
  input  logic            rst_ni,     // synchronous

  input  logic            clk_gated_i,  // of all flops but time and synchroniser
  output logic            active_o,     // clock request; 0: the next edge changes no flop of clk_gated_i

  /* verilator tracing_off */
  input  axi_lite_req_t   s_axi_i,
  output axi_lite_rsp_t   s_axi_o,
  /* verilator tracing_on */

  input  logic            trigger_i,  // one cycle per tick: snapshot of all axes
  input  logic [5:0]      servo_on_i, // drive enables of the arm; while one is 1, the filter registers are protected

  // Pins, one bit per axis, asynchronous.
  input  logic [Axes-1:0] enc_a_i,
  input  logic [Axes-1:0] enc_b_i,
  input  logic [Axes-1:0] enc_z_i
);

  /* verilator tracing_off */
  reg_req_t access;
  reg_rsp_t answer;
  encoder_reg2hw_t reg2hw;
  encoder_hw2reg_t hw2reg;
  /* verilator tracing_on */

  logic bus_active, core_active;
  assign active_o = bus_active || core_active;

  axi_lite_slave u_bus (
    .clk_i(clk_gated_i), .rst_ni, .active_o(bus_active), .s_axi_i, .s_axi_o, .reg_o(access), .reg_i(answer)
  );

  encoder_reg_top u_regs (
    .clk_i(clk_gated_i), .rst_ni, .protect_i(|servo_on_i), .reg_i(access), .reg_o(answer), .reg2hw_o(reg2hw),
    .hw2reg_i(hw2reg)
  );

  encoder_core #(.Axes(Axes), .PositionReset(PositionReset)) u_core (
    .clk_i, .rst_ni, .clk_gated_i, .active_o(core_active), .trigger_i, .enc_a_i, .enc_b_i, .enc_z_i,
    .reg2hw_i(reg2hw), .hw2reg_o(hw2reg)
  );

endmodule
