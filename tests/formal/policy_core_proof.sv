// policy_core with any image: whatever the memory gives, the outputs stay within the bound, no sum overflows, and a run
// ends in time. The memory is replaced by free rows.
`include "assert.svh"
`default_nettype none

module policy_core_proof (
  input wire         clk_i,
  input wire         rst_ni,
  input wire         ctrl_start_i,
  input wire         ctrl_irq_i,
  input wire         event_ended_i,
  input wire [6:0]   bound_value_i,
  input wire [31:0]  crc_value_i,
  input wire         id_re_i,
  input wire         address_we_i,
  input wire         address_re_i,
  input wire         data_we_i,
  input wire         data_re_i,
  input wire [31:0]  wdata_i,
  input wire [3:0]   wstrb_i,
  input wire [255:0] input_values_i
);

  logic         active_o, irq_o;
  logic [31:0]  id_rdata_o, crc_read_value_o, address_rdata_o, data_rdata_o;
  logic         status_busy_o, status_done_o, status_refused_o, status_corrupt_o, status_malformed_o;
  logic         event_ended_set_o;
  logic [12:0]  cycles_value_o;
  logic [63:0]  output_values_o;
  policy_core_flat u_dut (.*);

  `RESET_FIRST

  logic [31:0] crc_value_q;
  logic        done_q;
  always_ff @(posedge clk_i) begin
    crc_value_q <= crc_value_i;
    done_q      <= rst_ni && status_done_o;
  end

  for (genvar i = 0; i < 8; i++) begin : gen_output
    wire signed [7:0] value = output_values_o[8*i +: 8];
    `ASSERT(OutputStaysWithinTheBound, value <= $signed({1'b0, bound_value_i}) &&
            -value <= $signed({1'b0, bound_value_i}))
  end
  `ASSERT(NoOutputWithoutDone, status_done_o || output_values_o == '0)
  `ASSERT(NoOutputWhileBusy, !status_busy_o || !status_done_o)
  `ASSERT(DoneOnlyWithTheRightChecksum, !status_done_o || done_q || crc_read_value_o == crc_value_q)
  `ASSERT(DoneIsNeitherCorruptNorMalformed, !status_done_o || (!status_corrupt_o && !status_malformed_o))
  `ASSERT(BusyHasAClock, !status_busy_o || active_o)
  `REACH(AnOutputAtTheBound, status_done_o && output_values_o[7:0] == {1'b0, bound_value_i} && bound_value_i != '0)
  `REACH(ASecondLayerEnds, status_done_o && cycles_value_o > 13'd14)
  `REACH(CorruptImage, status_corrupt_o && !status_busy_o)

endmodule

// Any image: each row that is read is a new free value.
module policy_memory #(
  parameter int Lanes = 8
) (
  input  wire                           clk_i,
  input  wire                           write_i,
  input  wire [11:0]                    waddr_i,
  input  wire [31:0]                    wdata_i,
  input  wire                           read_i,
  input  wire [$clog2(16384/Lanes)-1:0] raddr_i,
  output wire [8*Lanes-1:0]             rdata_o
);
  (* anyseq *) wire [8*Lanes-1:0] any;
  assign rdata_o = any;
endmodule

// Any values of the layer before.
module policy_values #(
  parameter int Lanes = 8
) (
  input  wire                         clk_i,
  input  wire                         rst_ni,
  input  wire                         load_i,
  input  wire [255:0]                 inputs_i,
  input  wire                         turn_i,
  input  wire                         first_i,
  input  wire [$clog2(64/Lanes)-1:0]  row_i,
  output wire [8*Lanes-1:0]           row_o,
  input  wire                         write_i,
  input  wire [7:0]                   value_i,
  output wire [5:0]                   count_o
);
  (* anyseq *) wire [8*Lanes-1:0] any;
  (* anyseq *) wire [5:0]         any_count;
  assign row_o   = any;
  assign count_o = any_count;
endmodule

// Any products.
module policy_products #(
  parameter int Lanes = 8
) (
  input  wire                clk_i,
  input  wire                row_i,
  input  wire [8*Lanes-1:0]  weights_i,
  input  wire [8*Lanes-1:0]  values_i,
  output wire [16*Lanes-1:0] products_o
);
  (* anyseq *) wire [16*Lanes-1:0] any;
  assign products_o = any;
endmodule

// Any value.
module policy_requantise (
  input  wire               clk_i,
  input  wire               multiply_i,
  input  wire signed [24:0] sum_i,
  input  wire [15:0]        multiplier_i,
  input  wire [4:0]         shift_i,
  input  wire               finish_i,
  input  wire               relu_i,
  output wire [7:0]         value_o
);
  (* anyseq *) wire [7:0] any;
  assign value_o = any;
endmodule

// Any checksum that changes with rows only.
module policy_crc #(
  parameter int Lanes = 8
) (
  input  wire               clk_i,
  input  wire               rst_ni,
  input  wire               clear_i,
  input  wire               add_i,
  input  wire [8*Lanes-1:0] row_i,
  output wire [31:0]        crc_o
);
  (* anyseq *) wire [31:0] any;
  logic [31:0] crc_q;
  assign crc_o = crc_q;
  always_ff @(posedge clk_i) if (!rst_ni || clear_i || add_i) crc_q <= any;
endmodule

`default_nettype wire
