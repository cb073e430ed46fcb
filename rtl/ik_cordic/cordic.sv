// Iterative CORDIC with a main lane and four slave lanes (README.md: passes, formats, gains).
//
// start_i with vector_i turns the slaves by minus the angle of the main vector, which is angle_o; if that vector is
// zero, or without vector_i, by minus angle_i. angle_i must hold until done_o. A pass takes 34 clocks with
// vector_i, and 28 without it.
`include "assert.svh"

module cordic (
  input  logic               clk_i,
  input  logic               rst_ni,        // synchronous

  input  logic               load_main_i,
  input  logic        [1:0]  zero_below_i,
  input  logic        [3:0]  load_slave_i,
  input  logic signed [47:0] x_i,
  input  logic signed [47:0] y_i,

  input  logic               start_i,
  input  logic               vector_i,
  input  logic        [31:0] angle_i,
  output logic               busy_o,
  output logic               done_o,        // one clock
  output logic        [31:0] angle_o,
  output logic               zero_o,        // of the main vector

  input  logic        [1:0]  slave_i,       // whose coordinate is read
  input  logic               y_not_x_i,
  output logic signed [47:0] coordinate_o
);

  localparam logic [5:0] Normalise = 6'd1, Fold = 6'd7, First = 6'd8, Done = 6'd34;

  logic [5:0] state_q;
  logic       rotate_q;
  logic       fold, step, negate, clockwise, zero;
  logic [5:0] normalise;
  logic [4:0] shift;
  logic [31:0] angle;
  assign fold      = state_q == Fold;
  assign step      = state_q >= First && state_q < Done;
  assign shift     = 5'(state_q - First);
  assign normalise = state_q >= Normalise && state_q < Fold ? 6'd32 >> (state_q - Normalise) : '0;
  assign busy_o    = state_q != '0;
  assign done_o    = state_q == Done;
  assign angle_o   = rotate_q ? angle_i : angle;
  assign zero_o    = zero;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q  <= '0;
      rotate_q <= 1'b0;
    end else if (start_i) begin
      state_q  <= vector_i ? Normalise : Fold;
      rotate_q <= !vector_i || zero;
    end else if (state_q != '0) begin
      state_q <= done_o ? '0 : state_q + 6'd1;
    end
  end

  cordic_main u_main (
    .clk_i, .load_i(load_main_i), .zero_below_i, .x_i, .y_i, .zero_o(zero), .normalise_i(normalise), .fold_i(fold),
    .step_i(step), .shift_i(shift), .rotate_i(rotate_q), .angle_i, .negate_o(negate), .clockwise_o(clockwise),
    .angle_o(angle)
  );

  logic [4*48-1:0] x, y;
  for (genvar i = 0; i < 4; i++) begin : g_slave
    cordic_lane u_lane (
      .clk_i, .load_i(load_slave_i[i]), .x_i(x_i[35:0]), .y_i(y_i[35:0]), .negate_i(fold && negate), .step_i(step),
      .shift_i(shift), .clockwise_i(clockwise), .x_o(x[i*48 +: 48]), .y_o(y[i*48 +: 48])
    );
  end
  assign coordinate_o = y_not_x_i ? y[8'(slave_i)*48 +: 48] : x[8'(slave_i)*48 +: 48];

  `ASSERT(OnePassAtATime, !start_i || state_q == '0)
  `ASSERT(LoadsBetweenPasses, !(load_main_i || load_slave_i != '0) || state_q == '0)

endmodule
