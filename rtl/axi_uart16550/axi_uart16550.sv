// AXI UART 16550 v2.0 compatible block: byte registers in words from 0x1000 on, one interrupt line.
//
// A write that does not enable byte 0 changes nothing, so byte and word accesses are equivalent. irq_o is a level that
// follows the registers one clock later.
`include "axi_lite_types.svh"
`include "axi_uart16550_reg_types.svh"

module axi_uart16550 (
  input  logic          clk_i,
  input  logic          rst_ni,       // synchronous

  input  logic          clk_gated_i,  // gated clock, see axi_gpio
  output logic          active_o,     // clock request: the next edge of clk_i is needed

  /* verilator tracing_off */
  input  axi_lite_req_t s_axi_i,
  output axi_lite_rsp_t s_axi_o,
  /* verilator tracing_on */

  // Every input has a synchroniser, every output is a flop. Tie rxd_i and the modem inputs high when unused.
  input  logic          rxd_i,        // serial line, idle high
  output logic          txd_o,        // idles high
  input  logic          cts_ni,
  input  logic          dsr_ni,
  input  logic          dcd_ni,
  input  logic          ri_ni,
  output logic          rts_no,
  output logic          dtr_no,
  output logic          out1_no,
  output logic          out2_no,
  output logic          irq_o         // level, active high
);

  /* verilator tracing_off */
  reg_req_t access;
  reg_rsp_t answer;
  axi_uart16550_reg2hw_t reg2hw;
  axi_uart16550_hw2reg_t hw2reg;
  /* verilator tracing_on */

  // While the block is idle, only the synchroniser needs a clock.
  logic bus_active, core_awake;
  assign active_o = bus_active || core_awake;

  logic [4:0] lines;
  sync_2ff #(.Width(5)) u_sync (
    .clk_i, .rst_ni, .async_i({rxd_i, ~{dcd_ni, ri_ni, dsr_ni, cts_ni}}), .level_o(lines)
  );

  axi_lite_slave u_bus (
    .clk_i(clk_gated_i), .rst_ni, .active_o(bus_active), .s_axi_i, .s_axi_o, .reg_o(access), .reg_i(answer)
  );

  axi_uart16550_reg_top u_regs (
    .clk_i(clk_gated_i), .rst_ni, .reg_i(access), .reg_o(answer), .reg2hw_o(reg2hw), .hw2reg_i(hw2reg)
  );

  uart_core u_core (
    .clk_i(clk_gated_i), .rst_ni, .access_i(access.we || access.re), .reg2hw_i(reg2hw), .hw2reg_o(hw2reg),
    .rxd_i(lines[4]), .modem_i(lines[3:0]), .txd_o, .rts_no, .dtr_no, .out1_no, .out2_no, .irq_o, .awake_o(core_awake)
  );

endmodule
