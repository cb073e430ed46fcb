// A sum as 8 bits: (sum * multiplier + half) >> (16 + shift), limited; half is a half of what is shifted out.
module policy_requantise (
  input  logic               clk_i,
  input  logic               multiply_i,    // takes the sum, the multiplier and the shift
  input  logic signed [24:0] sum_i,
  input  logic [15:0]        multiplier_i,
  input  logic [4:0]         shift_i,
  input  logic               finish_i,      // one clock later
  input  logic               relu_i,        // negative values become 0
  output logic [7:0]         value_o        // signed; two clocks after multiply_i
);

  logic signed [41:0] product_q;
  logic signed [31:0] shifted_q;
  logic        [4:0]  shift_q;

  logic signed [47:0] rounded;
  assign rounded = 48'(product_q) + $signed(48'd1 << (6'd15 + {1'b0, shift_q}));

  always_ff @(posedge clk_i) begin
    if (multiply_i) begin
      product_q <= 42'(sum_i) * $signed({26'd0, multiplier_i});
      shift_q   <= shift_i;
    end
    if (finish_i) shifted_q <= 32'(rounded >>> (6'd16 + {1'b0, shift_q}));
  end

  assign value_o = shifted_q > 32'sd127             ? 8'h7F
                 : relu_i && shifted_q < 32'sd0     ? 8'h00
                 : shifted_q < -32'sd128            ? 8'h80 : shifted_q[7:0];

endmodule
