// The products of a row: signed bytes times signed bytes, one clock later.
module policy_products #(
  parameter int Lanes = 8
) (
  input  logic                clk_i,
  input  logic                row_i,       // takes a row
  input  logic [8*Lanes-1:0]  weights_i,   // signed bytes
  input  logic [8*Lanes-1:0]  values_i,    // signed bytes
  output logic [16*Lanes-1:0] products_o   // signed, 16 bits each; hold until the next row
);

  always_ff @(posedge clk_i) begin
    if (row_i) begin
      for (int i = 0; i < Lanes; i++) begin
        products_o[16*i +: 16] <= 16'($signed(weights_i[8*i +: 8])) * 16'($signed(values_i[8*i +: 8]));
      end
    end
  end

endmodule
