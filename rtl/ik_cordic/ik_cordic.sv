// Inverse kinematics by CORDIC with an AXI4-Lite port. Wiring of bus, register file and core, and what
// hides the results of a run that has not ended. Registers: ik_cordic_regs.toml.
`include "axi_lite_types.svh"
`include "ik_cordic_reg_types.svh"

module ik_cordic (
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
  reg_rsp_t answer, shown;
  ik_cordic_reg2hw_t reg2hw;
  ik_cordic_hw2reg_t hw2reg;
  /* verilator tracing_on */

  logic bus_active, core_active, busy;
  assign active_o = bus_active || core_active;
  assign busy     = hw2reg.status_busy;

  axi_lite_slave u_bus (
    .clk_i, .rst_ni, .active_o(bus_active), .s_axi_i, .s_axi_o, .reg_o(access), .reg_i(shown)
  );

  // BRANCHES, FLAGS and THETA read 0 while the core works on them.
  logic        re, hidden_q;
  logic [15:0] raddr;
  assign re    = access.re;
  assign raddr = {access.raddr[15:2], 2'b00};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) hidden_q <= 1'b0;
    else if (re) begin
      hidden_q <= busy && (raddr == ik_cordic_reg_pkg::BranchesOffset || raddr == ik_cordic_reg_pkg::FlagsOffset ||
                           raddr[15:8] == ik_cordic_reg_pkg::ThetaOffset[15:8]);
    end
  end

  logic [31:0] rdata;
  logic        rerr;
  assign rdata       = answer.rdata;
  assign rerr        = answer.rerr;
  assign shown.werr  = answer.werr;
  assign shown.rerr  = rerr;
  assign shown.rdata = hidden_q && !rerr ? '0 : rdata;

  ik_cordic_reg_top u_regs (
    .clk_i, .rst_ni, .reg_i(access), .reg_o(answer), .reg2hw_o(reg2hw), .hw2reg_i(hw2reg)
  );

  ik_core u_core (
    .clk_i, .rst_ni, .active_o(core_active), .reg2hw_i(reg2hw), .hw2reg_o(hw2reg), .irq_o
  );

endmodule
