// Two-flop synchroniser for slow, unrelated one-bit inputs: `level_o` follows `async_i` two cycles later.
// The bits may arrive one cycle apart, so a multi-bit code must not cross here.
module sync_2ff #(
  parameter int Width = 1
) (
  input  logic             clk_i,
  input  logic             rst_ni,   // synchronous; both flops 0
  input  logic [Width-1:0] async_i,
  output logic [Width-1:0] level_o
);

  (* ASYNC_REG = "TRUE" *) logic [Width-1:0] first_q, second_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      first_q  <= '0;
      second_q <= '0;
    end else begin
      first_q  <= async_i;
      second_q <= first_q;
    end
  end

  assign level_o = second_q;

endmodule
