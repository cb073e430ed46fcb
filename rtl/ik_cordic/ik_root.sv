// Integer part of the square root of 86 bits, one bit of the result per clock.
//
// done_o is 43 clocks after start_i. The root then holds until the next start.
`include "assert.svh"

module ik_root (
  input  logic        clk_i,
  input  logic        rst_ni,    // synchronous

  input  logic        start_i,
  input  logic [85:0] square_i,
  output logic        busy_o,
  output logic        done_o,    // one clock
  output logic [42:0] root_o
);

  localparam logic [5:0] Steps = 6'd43;

  logic [5:0]  left_q;  // bits that are left
  logic        done_q;
  logic [85:0] square_q;
  logic [43:0] rest_q;  // at most twice the root
  logic [42:0] root_q;
  logic [45:0] left, tried;
  logic        fits;
  assign busy_o = left_q != '0 || done_q;
  assign done_o = done_q;
  assign root_o = root_q;
  assign left   = {rest_q, square_q[85:84]};
  assign tried  = {1'b0, root_q, 2'b01};
  assign fits   = left >= tried;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_q <= '0;
      done_q <= 1'b0;
    end else begin
      done_q <= left_q == 6'd1;
      if (start_i) left_q <= Steps;
      else if (left_q != '0) left_q <= left_q - 6'd1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (start_i) begin
      square_q <= square_i;
      rest_q   <= '0;
      root_q   <= '0;
    end else if (left_q != '0) begin
      square_q <= {square_q[83:0], 2'b00};
      rest_q   <= fits ? 44'(left - tried) : left[43:0];
      root_q   <= {root_q[41:0], fits};
    end
  end

  `ASSERT(OneRootAtATime, !start_i || left_q == '0)

endmodule
