// A neuron: products of a row in each clock, sum, requantisation to 8 bits. A pipeline; the rows of a neuron come in a
// row, and its parameters one clock or more before the first.
//
//   clock  0                  1        2     3                    4        5
//          policy_products    row sum  sum   policy_requantise             value_o, done_o
`include "assert.svh"

module policy_neuron #(
  parameter int Lanes = 8
) (
  input  logic               clk_i,
  input  logic               rst_ni,        // synchronous

  input  logic               set_i,         // takes the parameters
  input  logic signed [23:0] bias_i,
  input  logic [15:0]        multiplier_i,
  input  logic [4:0]         shift_i,

  input  logic               row_i,         // takes a row
  input  logic [3:0]         index_i,       // of the row: 0 is the first one of a neuron, each next one is 1 more
  input  logic               last_i,
  input  logic [8*Lanes-1:0] weights_i,     // signed bytes
  input  logic [8*Lanes-1:0] values_i,      // signed bytes

  input  logic               relu_i,        // negative values become 0
  output logic [5:1]         filled_o,      // stages of the pipeline that hold something
  output logic               done_o,        // a value
  output logic [7:0]         value_o        // signed
);

  // Parameters, and copies for the later stages: those of the next neuron may come two clocks after the last row.
  logic signed [23:0] bias_q;
  logic        [15:0] multiplier_q, multiplier_2_q;
  logic        [4:0]  shift_q, shift_2_q;

  logic [2:1] row_q;  // of the stages
  logic [5:1] last_q;
  logic [2:1] first_q;
  logic [16*Lanes-1:0] products_q;
  logic signed [24:0]  row_sum_q, sum_q;

  assign done_o   = last_q[5];
  assign filled_o = last_q | {3'b000, row_q};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q  <= '0;
      last_q <= '0;
    end else begin
      row_q  <= {row_q[1], row_i};
      last_q <= {last_q[4:1], row_i && last_i};
    end
  end

  // As wide as all products need, so that a proof sees its range.
  localparam int SumBits = 16 + $clog2(Lanes);
  function automatic logic signed [SumBits-1:0] sum_of(logic [16*Lanes-1:0] products);
    sum_of = '0;
    for (int i = 0; i < Lanes; i++) sum_of = sum_of + SumBits'($signed(products[16*i +: 16]));
  endfunction

  logic signed [SumBits-1:0] products_sum;
  logic signed [24:0]        row_sum, addend;
  assign products_sum = sum_of(products_q);
  assign row_sum      = first_q[1] ? 25'(products_sum) + 25'(bias_q) : 25'(products_sum);
  assign addend       = first_q[2] ? '0 : sum_q;

  always_ff @(posedge clk_i) begin
    if (set_i) begin
      bias_q       <= bias_i;
      multiplier_q <= multiplier_i;
      shift_q      <= shift_i;
    end
    if (row_i) first_q[1] <= index_i == '0;
    if (row_q[1]) begin
      first_q[2] <= first_q[1];
      row_sum_q  <= row_sum;
    end
    if (last_q[1]) begin
      multiplier_2_q <= multiplier_q;
      shift_2_q      <= shift_q;
    end
    if (row_q[2]) sum_q <= addend + row_sum_q;
  end

  policy_products #(.Lanes(Lanes)) u_products (.clk_i, .row_i, .weights_i, .values_i, .products_o(products_q));
  policy_requantise u_requantise (
    .clk_i, .multiply_i(last_q[3]), .sum_i(sum_q), .multiplier_i(multiplier_2_q), .shift_i(shift_2_q),
    .finish_i(last_q[4]), .relu_i, .value_o
  );

`ifdef ASSERT_ON
  // Limits of the sums: 25 bits hold every one.
  localparam logic signed [26:0] RowLimit  = 27'(Lanes * 32768);  // products have 16 bits
  localparam logic signed [26:0] BiasLimit = 27'sd1 << 23;
  logic [3:0] index_1_q, index_2_q, index_3_q;
  logic signed [26:0] row_limit, sum_limit;
  assign row_limit = RowLimit + (first_q[2] ? BiasLimit : 27'sd0);
  assign sum_limit = BiasLimit + RowLimit * $signed({23'd0, index_3_q} + 27'd1);
  always_ff @(posedge clk_i) begin
    if (row_i) index_1_q <= index_i;
    if (row_q[1]) index_2_q <= index_1_q;
    if (row_q[2]) index_3_q <= index_2_q;
  end
  logic [2:0] held_q;  // the stages that have had a row since the reset
  always_ff @(posedge clk_i) begin
    if (!rst_ni) held_q <= '0;
    else held_q <= held_q | {row_q[2], row_q[1], row_i};
  end
  `ASSERT(WhatMovesIsHeld, (!row_q[1] || held_q[0]) && (!row_q[2] || held_q[1]))
  `ASSERT(RowsComeInOrder, !row_i || index_i == '0 || (row_q[1] && index_i == index_1_q + 4'd1))
  `ASSERT(RowSumsComeInOrder, !row_q[1] || index_1_q == '0 || (row_q[2] && index_1_q == index_2_q + 4'd1))
  `ASSERT(SumsComeInOrder, !row_q[2] || index_2_q == '0 || (held_q[2] && index_2_q == index_3_q + 4'd1))
  `ASSERT(FirstIsIndex0, (!held_q[0] || first_q[1] == (index_1_q == '0)) &&
          (!held_q[1] || first_q[2] == (index_2_q == '0)))
  `ASSERT(RowSumIsLimited, !held_q[1] || (27'(row_sum_q) <= row_limit && 27'(row_sum_q) >= -row_limit))
  `ASSERT(SumIsLimited, !held_q[2] || (27'(sum_q) <= sum_limit && 27'(sum_q) >= -sum_limit))
  `ASSERT(SumIsExact, !row_q[2] || 26'(addend) + 26'(row_sum_q) == 26'($signed(25'(addend + row_sum_q))))
`endif

endmodule
