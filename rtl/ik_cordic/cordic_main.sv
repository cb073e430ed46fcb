// The main lane of the CORDIC: the vector that is turned onto the x axis, and the angle.
//
// zero_o: both components were below 2^0, 2^6 or 2^11 (zero_below_i 0, 1, 2) when they were loaded. Magnitudes are
// those of the one's complement.
module cordic_main (
  input  logic               clk_i,

  input  logic               load_i,
  input  logic        [1:0]  zero_below_i,
  input  logic signed [47:0] x_i,
  input  logic signed [47:0] y_i,
  output logic               zero_o,

  input  logic        [5:0]  normalise_i,  // shifts left by 32, 16, 8, 4, 2 or 1 (bit 0) if that fits 45 bits
  input  logic               fold_i,       // half a turn if needed
  input  logic               step_i,       // a turn by atan(2^-shift_i)
  input  logic        [4:0]  shift_i,

  input  logic               rotate_i,     // drives angle_i to 0 instead of y
  input  logic        [31:0] angle_i,      // while fold_i
  output logic               negate_o,     // with fold_i: half a turn
  output logic               clockwise_o,  // with step_i
  output logic        [31:0] angle_o       // by which the vector was turned clockwise, 2^-32 turns
);

  logic signed [47:0] x_q, y_q;
  logic               zero_q;
  logic        [31:0] angle_q;
  assign zero_o  = zero_q;
  assign angle_o = angle_q;

  // round(atan(2^-i) / (2 pi) * 2^32)
  logic [31:0] arctangent;
  always_comb begin
    case (shift_i)
      5'd0:    arctangent = 32'd536870912;
      5'd1:    arctangent = 32'd316933406;
      5'd2:    arctangent = 32'd167458907;
      5'd3:    arctangent = 32'd85004756;
      5'd4:    arctangent = 32'd42667331;
      5'd5:    arctangent = 32'd21354465;
      5'd6:    arctangent = 32'd10679838;
      5'd7:    arctangent = 32'd5340245;
      5'd8:    arctangent = 32'd2670163;
      5'd9:    arctangent = 32'd1335087;
      5'd10:   arctangent = 32'd667544;
      5'd11:   arctangent = 32'd333772;
      5'd12:   arctangent = 32'd166886;
      5'd13:   arctangent = 32'd83443;
      5'd14:   arctangent = 32'd41722;
      5'd15:   arctangent = 32'd20861;
      5'd16:   arctangent = 32'd10430;
      5'd17:   arctangent = 32'd5215;
      5'd18:   arctangent = 32'd2608;
      5'd19:   arctangent = 32'd1304;
      5'd20:   arctangent = 32'd652;
      5'd21:   arctangent = 32'd326;
      5'd22:   arctangent = 32'd163;
      5'd23:   arctangent = 32'd81;
      5'd24:   arctangent = 32'd41;
      default: arctangent = 32'd20;
    endcase
  end

  logic [47:0]  loaded;
  logic [44:13] held;
  assign loaded = (x_i ^ {48{x_i[47]}}) | (y_i ^ {48{y_i[47]}});
  assign held   = (x_q[44:13] ^ {32{x_q[47]}}) | (y_q[44:13] ^ {32{y_q[47]}});

  logic shorter;  // the vector can be shifted by what normalise_i asks for
  assign shorter =
              (normalise_i[5] && held[44:13] == '0) || (normalise_i[4] && held[44:29] == '0) ||
              (normalise_i[3] && held[44:37] == '0) || (normalise_i[2] && held[44:41] == '0) ||
              (normalise_i[1] && held[44:43] == '0) || (normalise_i[0] && !held[44]);

  assign negate_o    = rotate_i ? angle_i[31] ^ angle_i[30] : x_q[47];
  assign clockwise_o = rotate_i ? !angle_q[31] : !y_q[47];

  logic signed [47:0] dx, dy;
  assign dx = y_q >>> shift_i;
  assign dy = x_q >>> shift_i;

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      x_q    <= x_i;
      y_q    <= y_i;
      zero_q <= loaded[47:11] == '0 && (zero_below_i[1] || loaded[10:6] == '0) &&
                (zero_below_i != 2'd0 || loaded[5:0] == '0);
    end else if (shorter) begin
      x_q <= normalise_i[5] ? x_q <<< 32 : normalise_i[4] ? x_q <<< 16 : normalise_i[3] ? x_q <<< 8 :
             normalise_i[2] ? x_q <<< 4 : normalise_i[1] ? x_q <<< 2 : x_q <<< 1;
      y_q <= normalise_i[5] ? y_q <<< 32 : normalise_i[4] ? y_q <<< 16 : normalise_i[3] ? y_q <<< 8 :
             normalise_i[2] ? y_q <<< 4 : normalise_i[1] ? y_q <<< 2 : y_q <<< 1;
    end else if (fold_i && negate_o) begin
      x_q <= -x_q;
      y_q <= -y_q;
    end else if (step_i) begin
      x_q <= clockwise_o ? x_q + dx : x_q - dx;
      y_q <= clockwise_o ? y_q - dy : y_q + dy;
    end
    if (fold_i) angle_q <= rotate_i ? {angle_i[31] ^ negate_o, angle_i[30:0]} : {negate_o, 31'd0};
    else if (step_i) angle_q <= clockwise_o ^ rotate_i ? angle_q + arctangent : angle_q - arctangent;
  end

endmodule
