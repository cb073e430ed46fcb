// quad_decoder against the cycle of quadrature states, written as a table of states instead of an exclusive or.
`include "assert.svh"
`default_nettype none

module quad_decoder_proof (
  input wire       clk_i,
  input wire       rst_ni,
  input wire [1:0] a_i,
  input wire [1:0] b_i,
  input wire [1:0] known_i
);

  logic [1:0] up_o, down_o, illegal_o;
  quad_decoder #(.Axes(2)) u_dut (.*);

  `RESET_FIRST

  // Index of {a, b} in the sequence of increasing position: A leads B (Vo 2021, Table 1).
  function automatic logic [1:0] place(input logic a, input logic b);
    case ({a, b})
      2'b00: place = 2'd0;
      2'b10: place = 2'd1;
      2'b11: place = 2'd2;
      default: place = 2'd3;
    endcase
  endfunction

  logic after_q = 1'b0;  // the previous clock was outside reset
  always_ff @(posedge clk_i) after_q <= rst_ni;

  for (genvar i = 0; i < 2; i++) begin : gen_axis
    logic       a_q, b_q;
    logic [1:0] moved;
    always_ff @(posedge clk_i) {a_q, b_q} <= {a_i[i], b_i[i]};
    assign moved = place(a_i[i], b_i[i]) - place(a_q, b_q);
    `ASSERT(UpIsOnePlaceOn, !after_q || up_o[i] == (known_i[i] && moved == 2'd1))
    `ASSERT(DownIsOnePlaceBack, !after_q || down_o[i] == (known_i[i] && moved == 2'd3))
    `ASSERT(IllegalIsTwoPlaces, !after_q || illegal_o[i] == (known_i[i] && moved == 2'd2))
    `ASSERT(OneVerdict, $onehot0({up_o[i], down_o[i], illegal_o[i]}))
    `REACH(Up, after_q && up_o[i])
    `REACH(Down, after_q && down_o[i])
    `REACH(Illegal, after_q && illegal_o[i])
  end
  `REACH(OppositeWays, after_q && up_o[0] && down_o[1])

endmodule

`default_nettype wire
