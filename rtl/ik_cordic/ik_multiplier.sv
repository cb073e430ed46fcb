// Product of two signed words, in three digits of 16 bits: a multiplier of 48 x 17 bits and an accumulator.
//
// The operands must hold from the clock of start_i until done_o, Clocks later. The product then holds until the next
// start. rounded_o is the product without its low 30 (shift_i 0) or 16 bits (1), rounded to nearest, halves upwards.
`include "assert.svh"

module ik_multiplier (
  input  logic               clk_i,
  input  logic               rst_ni,   // synchronous

  input  logic               start_i,
  input  logic               shift_i,
  input  logic signed [47:0] a_i,
  input  logic signed [47:0] b_i,
  output logic               busy_o,
  output logic               done_o,      // one clock
  output logic        [85:0] product_o,   // without its upper bits
  output logic signed [47:0] rounded_o
);

  logic [4:0] step_q;  // one-hot: digits 0, 1, 2 are multiplied; the last one is added; done
  logic signed [16:0] digit;
  logic signed [64:0] part_q;
  logic signed [65:0] high_q;
  logic        [31:0] low_q;
  assign busy_o    = step_q != '0;
  assign done_o    = step_q[4];
  assign product_o = {high_q[53:0], low_q};

  assign digit = start_i ? {1'b0, b_i[15:0]} : step_q[0] ? {1'b0, b_i[31:16]} : {b_i[47], b_i[47:32]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) step_q <= '0;
    else         step_q <= {step_q[3:0], start_i};
  end

  always_ff @(posedge clk_i) begin
    if (start_i || step_q[0] || step_q[1]) part_q <= a_i * digit;
    if (step_q[0]) high_q <= 66'(part_q);
    if (step_q[1] || step_q[2]) begin
      high_q <= (high_q >>> 16) + 66'(part_q);
      low_q  <= {high_q[15:0], low_q[31:16]};
    end
  end

  logic half;
  logic signed [47:0] whole;
  assign half      = shift_i ? product_o[15] : product_o[29];
  assign whole     = shift_i ? product_o[63:16] : product_o[77:30];
  assign rounded_o = whole + 48'(half);

  `ASSERT(OneProductAtATime, !start_i || step_q == '0)

endmodule
