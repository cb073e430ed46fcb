// CRC-32 of IEEE 802.3 over the bytes of rows, the first byte in bits 7:0.
module policy_crc #(
  parameter int Lanes = 8  // bytes of a row
) (
  input  logic               clk_i,
  input  logic               rst_ni,   // synchronous

  input  logic               clear_i,
  input  logic               add_i,    // a row
  input  logic [8*Lanes-1:0] row_i,
  output logic [31:0]        crc_o     // of the rows since clear_i; 0 if there are none
);

  logic [31:0] crc_q;
  assign crc_o = ~crc_q;

  function automatic logic [31:0] following(logic [31:0] crc, logic [8*Lanes-1:0] row);
    following = crc;
    for (int i = 0; i < 8 * Lanes; i++) begin
      following = (following >> 1) ^ (following[0] ^ row[i] ? 32'hEDB8_8320 : 32'd0);
    end
  endfunction

  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) crc_q <= '1;
    else if (add_i)         crc_q <= following(crc_q, row_i);
  end

endmodule
