// The results of a run: joint angles, which branches exist, and what is special about them.
//
// A branch is 4 shoulder + 2 elbow + flip. The angles of flip + are written, and those of flip - follow from them, also
// where this branch does not exist.
`include "assert.svh"

module ik_results (
  input  logic          clk_i,
  input  logic          rst_ni,         // synchronous

  input  logic          clear_i,        // a run starts
  input  logic          five_r_i,
  input  logic          shoulder_i,     // of what is written
  input  logic          elbow_i,

  input  logic          write_i,        // the angle of a joint; that of joint 5 makes the branches exist
  input  logic [2:0]    joint_i,        // 0..5
  input  logic [31:0]   angle_i,
  input  logic          flag_i,         // sets the flags that are 1
  input  logic          flag_shoulder_i,
  input  logic          flag_elbow_i,
  input  logic          flag_clamped_i,
  input  logic          flag_folded_i,
  input  logic          flag_wrist_i,

  output logic [7:0]    valid_o,
  output logic          shoulder_o,
  output logic [1:0]    elbow_o,
  output logic [1:0]    clamped_o,
  output logic [1:0]    folded_o,
  output logic [3:0]    wrist_o,
  output logic [1535:0] theta_o         // element 6 branch + joint; flip + is 0 until it is written
);

  logic [1:0] posture;
  logic [3:0] posture_bit;
  logic [1:0] shoulder_bit;
  assign posture      = {shoulder_i, elbow_i};
  assign posture_bit  = 4'd1 << posture;
  assign shoulder_bit = {shoulder_i, !shoulder_i};

  logic [3:0] solved_q, wrist_q;  // bit: posture
  logic [1:0] elbow_q, clamped_q, folded_q;
  logic       shoulder_q;
  assign shoulder_o = shoulder_q;
  assign elbow_o    = elbow_q;
  assign clamped_o  = clamped_q;
  assign folded_o   = folded_q;
  assign wrist_o    = wrist_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) begin
      solved_q   <= '0;
      wrist_q    <= '0;
      elbow_q    <= '0;
      clamped_q  <= '0;
      folded_q   <= '0;
      shoulder_q <= 1'b0;
    end else begin
      if (write_i && joint_i == 3'd5) solved_q <= solved_q | posture_bit;
      if (flag_i) begin
        if (flag_shoulder_i) shoulder_q <= 1'b1;
        if (flag_elbow_i) elbow_q <= elbow_q | shoulder_bit;
        if (flag_clamped_i) clamped_q <= clamped_q | shoulder_bit;
        if (flag_folded_i) folded_q <= folded_q | shoulder_bit;
        if (flag_wrist_i) wrist_q <= wrist_q | posture_bit;
      end
    end
  end

  logic [31:0] opposite;  // theta_5 of flip -
  assign opposite = 32'd0 - angle_i;

  for (genvar i = 0; i < 4; i++) begin : g_posture
    assign valid_o[2*i]   = solved_q[i];
    assign valid_o[2*i+1] = solved_q[i] && !five_r_i && !wrist_q[i];
    for (genvar joint = 0; joint < 6; joint++) begin : g_joint
      logic [31:0] angle_q;
      always_ff @(posedge clk_i) begin
        if (!rst_ni || clear_i) angle_q <= '0;
        else if (write_i && posture == 2'(i) && joint_i == 3'(joint)) angle_q <= angle_i;
      end

      logic [31:0] flipped;
      if (joint == 4) begin : g_negated
        logic [31:0] opposite_q;
        assign flipped = opposite_q;
        always_ff @(posedge clk_i) begin
          if (!rst_ni || clear_i) opposite_q <= '0;
          else if (write_i && posture == 2'(i) && joint_i == 3'd4) opposite_q <= opposite;
        end
      end else if (joint == 3 || joint == 5) begin : g_half_turn
        assign flipped = {!angle_q[31], angle_q[30:0]};
      end else begin : g_same
        assign flipped = angle_q;
      end
      assign theta_o[(12*i+joint)*32 +: 32]   = angle_q;
      assign theta_o[(12*i+6+joint)*32 +: 32] = flipped;
    end
  end

  `ASSERT(JointExists, !write_i || joint_i < 3'd6)

endmodule
