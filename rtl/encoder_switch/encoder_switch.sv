// Vo's encoder switch with an AXI4-Lite port: the inputs are six encoders, the output is the selected one.
// Registers: encoder_switch_regs.toml.
//
// It is a plain multiplexer, as in the paper. The decoder behind it gets no notice that the encoder has changed.
`include "assert.svh"
`include "axi_lite_types.svh"
`include "encoder_switch_reg_types.svh"

module encoder_switch (
  input  logic        clk_i,
  input  logic        rst_ni,       // synchronous

  input  logic        clk_gated_i,  // of the bus and its registers
  output logic        active_o,     // clock request; 0: the next edge changes no flop of clk_gated_i

  /* verilator tracing_off */
  input  axi_lite_req_t s_axi_i,
  output axi_lite_rsp_t s_axi_o,
  /* verilator tracing_on */

  // Pins, one bit per axis, asynchronous.
  input  logic [5:0]  enc_a_i,
  input  logic [5:0]  enc_b_i,
  input  logic [5:0]  enc_z_i,

  // The selected encoder, one clock edge later. There is only one flop, which may go metastable. Connect these outputs
  // to the synchroniser of a decoder only.
  output logic        enc_a_o,
  output logic        enc_b_o,
  output logic        enc_z_o
);

  /* verilator tracing_off */
  reg_req_t access;
  reg_rsp_t answer;
  encoder_switch_reg2hw_t reg2hw;
  /* verilator tracing_on */

  axi_lite_slave u_bus (
    .clk_i(clk_gated_i), .rst_ni, .active_o, .s_axi_i, .s_axi_o, .reg_o(access), .reg_i(answer)
  );

  encoder_switch_reg_top u_regs (.clk_i(clk_gated_i), .rst_ni, .reg_i(access), .reg_o(answer), .reg2hw_o(reg2hw));

  logic [2:0] select;
  assign select = reg2hw.select_axis;

  (* ASYNC_REG = "TRUE" *) logic a_q, b_q, z_q;
  assign enc_a_o = a_q;
  assign enc_b_o = b_q;
  assign enc_z_o = z_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {a_q, b_q, z_q} <= '0;
    end else begin
      a_q <= enc_a_i[select] && select < 3'd6;
      b_q <= enc_b_i[select] && select < 3'd6;
      z_q <= enc_z_i[select] && select < 3'd6;
    end
  end

  `COVER(NoneSelected, select >= 3'd6)

endmodule
