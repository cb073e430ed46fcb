// A slave lane of the CORDIC: turns a vector by the steps of the main lane.
//
// A word gets 4 guard bits when it is loaded, and loses them by rounding when it is read.
module cordic_lane (
  input  logic               clk_i,

  input  logic               load_i,
  input  logic        [35:0] x_i,
  input  logic        [35:0] y_i,

  input  logic               negate_i,     // half a turn
  input  logic               step_i,       // a turn by atan(2^-shift_i)
  input  logic        [4:0]  shift_i,
  input  logic               clockwise_i,

  output logic signed [47:0] x_o,
  output logic signed [47:0] y_o
);

  logic signed [39:0] x_q, y_q;

  // Without the guard bits. The half is added to the bit below the word.
  assign x_o = {{12{x_q[39]}}, x_q[39:4]} + 48'(x_q[3]);
  assign y_o = {{12{y_q[39]}}, y_q[39:4]} + 48'(y_q[3]);

  // One adder per coordinate: 0 - x, x - dy or x + dy.
  logic signed [39:0] x_base, y_base, x_part, y_part;
  assign x_base = negate_i ? '0 : x_q;
  assign y_base = negate_i ? '0 : y_q;
  assign x_part = negate_i ? x_q : y_q >>> shift_i;
  assign y_part = negate_i ? y_q : x_q >>> shift_i;

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      x_q <= {x_i, 4'b0000};
      y_q <= {y_i, 4'b0000};
    end else if (negate_i || step_i) begin
      x_q <= clockwise_i && !negate_i ? x_base + x_part : x_base - x_part;
      y_q <= clockwise_i || negate_i ? y_base - y_part : y_base + y_part;
    end
  end

endmodule
