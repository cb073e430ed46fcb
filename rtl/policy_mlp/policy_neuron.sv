// A neuron: products of a row in each clock, sum, requantisation to 8 bits. A pipeline; the rows of a neuron come in a
// row, and its parameters one clock or more before the first.
//
//   clock  0           1        2     3            4        5
//          products    row sum  sum   x multiplier shifted  value_o, done_o
//
// value_o = (sum * multiplier + half) >> (16 + shift), limited to 8 bits; half is a half of what is shifted out.
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
  logic        [4:0]  shift_q, shift_2_q, shift_4_q;

  logic [2:1] row_q;  // of the stages
  logic [5:1] last_q;
  logic [2:1] first_q;
  logic [16*Lanes-1:0] products_q;
  logic signed [24:0]  row_sum_q, sum_q;
  logic signed [41:0]  product_q;
  logic signed [31:0]  shifted_q;

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

  function automatic logic signed [24:0] sum_of(logic signed [24:0] first, logic [16*Lanes-1:0] products);
    sum_of = first;
    for (int i = 0; i < Lanes; i++) sum_of = sum_of + 25'($signed(products[16*i +: 16]));
  endfunction

  logic signed [24:0] row_sum, addend;
  assign row_sum = sum_of(first_q[1] ? 25'(bias_q) : 25'sd0, products_q);
  assign addend = first_q[2] ? '0 : sum_q;

  logic signed [47:0] rounded;
  assign rounded = 48'(product_q) + $signed(48'd1 << (6'd15 + {1'b0, shift_4_q}));

  always_ff @(posedge clk_i) begin
    if (set_i) begin
      bias_q       <= bias_i;
      multiplier_q <= multiplier_i;
      shift_q      <= shift_i;
    end
    if (row_i) begin
      first_q[1] <= index_i == '0;
      for (int i = 0; i < Lanes; i++) begin
        products_q[16*i +: 16] <= 16'($signed(weights_i[8*i +: 8])) * 16'($signed(values_i[8*i +: 8]));
      end
    end
    if (row_q[1]) begin
      first_q[2] <= first_q[1];
      row_sum_q  <= row_sum;
    end
    if (last_q[1]) begin
      multiplier_2_q <= multiplier_q;
      shift_2_q      <= shift_q;
    end
    if (row_q[2]) sum_q <= addend + row_sum_q;
    if (last_q[3]) begin
      product_q <= 42'(sum_q) * $signed({26'd0, multiplier_2_q});
      shift_4_q <= shift_2_q;
    end
    if (last_q[4]) shifted_q <= 32'(rounded >>> (6'd16 + {1'b0, shift_4_q}));
  end

  assign value_o = shifted_q > 32'sd127             ? 8'h7F
                 : relu_i && shifted_q < 32'sd0     ? 8'h00
                 : shifted_q < -32'sd128            ? 8'h80 : shifted_q[7:0];

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
  `ASSERT(RowsComeInOrder, !row_i || index_i == '0 || (held_q[0] && index_i == index_1_q + 4'd1))
  `ASSERT(RowSumsComeInOrder, !row_q[1] || index_1_q == '0 || (held_q[1] && index_1_q == index_2_q + 4'd1))
  `ASSERT(SumsComeInOrder, !row_q[2] || index_2_q == '0 || (held_q[2] && index_2_q == index_3_q + 4'd1))
  `ASSERT(FirstIsIndex0, (!held_q[0] || first_q[1] == (index_1_q == '0)) && (!held_q[1] || first_q[2] == (index_2_q == '0)))
  `ASSERT(RowSumIsLimited, !held_q[1] || (27'(row_sum_q) <= row_limit && 27'(row_sum_q) >= -row_limit))
  `ASSERT(SumIsLimited, !held_q[2] || (27'(sum_q) <= sum_limit && 27'(sum_q) >= -sum_limit))
  `ASSERT(SumIsExact, !row_q[2] || 26'(addend) + 26'(row_sum_q) == 26'($signed(25'(addend + row_sum_q))))
`endif

endmodule
