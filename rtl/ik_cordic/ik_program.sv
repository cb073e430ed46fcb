// The program of ik_core: the equations of README.md in steps. A step is
//
//   operation [25:22]   destination [21:16]   operands a [15:10] and b [9:4]   argument [3:0]   (ik_pkg)
//
// Destination and operands are addresses of the scratch memory. A jump has its target in [11:4].
module ik_program (
  input  logic [7:0]  step_i,
  output logic [25:0] code_o
);

  // Scratch memory. What a start copies, in the order of ik_core; x and y of the columns n, o, a are overwritten by
  // outward and across, and their z by z G.
  localparam logic [5:0] NX = 6'd0, NY = 6'd1, NZ = 6'd2, OX = 6'd3, OY = 6'd4, OZ = 6'd5, AX = 6'd6, AY = 6'd7,
                         AZ = 6'd8, PX = 6'd9, PY = 6'd10, PZ = 6'd11, A1 = 6'd12, Base = 6'd13, Upper = 6'd14,
                         Forearm = 6'd15, A4 = 6'd16, Hand = 6'd17, Phi = 6'd18, Previous1 = 6'd19,
                         Previous2 = 6'd20, Previous4 = 6'd21, Zero = 6'd22, Gain = 6'd23, Ungain = 6'd24,
                         HalfTurn = 6'd25;
  // Intermediate results.
  localparam logic [5:0] WX = 6'd26, WY = 6'd27, WZ = 6'd28, T0 = 6'd29, T1 = 6'd30, X = 6'd31, Y = 6'd32,
                         Theta1 = 6'd33, Theta2 = 6'd34, Theta3 = 6'd35, Theta5 = 6'd36, Pitch = 6'd37,
                         OffsetX = 6'd38, OffsetY = 6'd39, Farthest2 = 6'd40, Nearest2 = 6'd41, Difference2 = 6'd42,
                         Sum2 = 6'd43, Distance2 = 6'd44, ToOuter = 6'd45, ToInner = 6'd46, Area = 6'd47,
                         Beta = 6'd48, Delta = 6'd49, Gamma = 6'd50, N1 = 6'd51, O1 = 6'd52, H1 = 6'd53;

  // First step of each part.
  localparam logic [7:0] HeadOfFive = 8'd9, Plane = HeadOfFive + 8'd13, ToolOfFive = Plane + 8'd25,
                         HandOfSix = ToolOfFive + 8'd14, Shoulder = HandOfSix + 8'd9, Elbow = Shoulder + 8'd26,
                         Wrist = Elbow + 8'd12, Bend = Wrist + 8'd26, Next = Bend + 8'd3, BackOfSix = Next + 8'd8,
                         Stop = BackOfSix + 8'd7;

  function automatic logic [25:0] jump(input logic [3:0] condition, input logic [7:0] target);
    jump = {ik_pkg::Jump, 10'd0, target, condition};
  endfunction

  always_comb begin
    case (step_i)
      // Wrist centre: position - hand * approach.
      8'd0:  code_o = {ik_pkg::Multiply, T0, Hand, AX, ik_pkg::ByUnit};
      8'd1:  code_o = {ik_pkg::Subtract, WX, PX, T0, ik_pkg::None};
      8'd2:  code_o = {ik_pkg::Multiply, T0, Hand, AY, ik_pkg::ByUnit};
      8'd3:  code_o = {ik_pkg::Subtract, WY, PY, T0, ik_pkg::None};
      8'd4:  code_o = {ik_pkg::Multiply, T0, Hand, AZ, ik_pkg::ByUnit};
      8'd5:  code_o = {ik_pkg::Subtract, WZ, PZ, T0, ik_pkg::None};
      8'd6:  code_o = jump(ik_pkg::IfFiveR, HeadOfFive);
      8'd7:  code_o = {ik_pkg::LoadMain, Zero, WX, WY, ik_pkg::ZeroLength};
      8'd8:  code_o = jump(ik_pkg::Always, Plane);

      // Five axes: the heading is the tool point, or near axis 1 the approach, with the sign that points to the tool.
      HeadOfFive + 8'd0:  code_o = {ik_pkg::Multiply, T0, PX, AX, ik_pkg::BySquare};
      HeadOfFive + 8'd1:  code_o = {ik_pkg::Multiply, T1, PY, AY, ik_pkg::BySquare};
      HeadOfFive + 8'd2:  code_o = {ik_pkg::Add, T0, T0, T1, ik_pkg::None};
      HeadOfFive + 8'd3:  code_o = {ik_pkg::Subtract, X, Zero, AX, ik_pkg::None};
      HeadOfFive + 8'd4:  code_o = {ik_pkg::Subtract, Y, Zero, AY, ik_pkg::None};
      HeadOfFive + 8'd5:  code_o = {ik_pkg::Test, Zero, T0, Zero, ik_pkg::Negative};
      HeadOfFive + 8'd6:  code_o = {ik_pkg::Select, X, X, AX, ik_pkg::None};
      HeadOfFive + 8'd7:  code_o = {ik_pkg::Select, Y, Y, AY, ik_pkg::None};
      HeadOfFive + 8'd8:  code_o = {ik_pkg::Test, Zero, PX, PY, ik_pkg::Near};
      HeadOfFive + 8'd9:  code_o = {ik_pkg::Test, Zero, AX, AY, ik_pkg::AndNotNear};
      HeadOfFive + 8'd10: code_o = {ik_pkg::Select, X, X, PX, ik_pkg::None};
      HeadOfFive + 8'd11: code_o = {ik_pkg::Select, Y, Y, PY, ik_pkg::None};
      HeadOfFive + 8'd12: code_o = {ik_pkg::LoadMain, Zero, X, Y, ik_pkg::ZeroLength};

      // theta_1, and everything in the plane of the arm: x outward, y across. Then the squares of the links.
      Plane + 8'd0:  code_o = {ik_pkg::LoadSlave, Zero, NX, NY, 4'd0};
      Plane + 8'd1:  code_o = {ik_pkg::LoadSlave, Zero, OX, OY, 4'd1};
      Plane + 8'd2:  code_o = {ik_pkg::LoadSlave, Zero, AX, AY, 4'd2};
      Plane + 8'd3:  code_o = {ik_pkg::LoadSlave, Zero, WX, WY, 4'd3};
      Plane + 8'd4:  code_o = {ik_pkg::Vector, Theta1, Previous1, Zero, ik_pkg::FlagShoulder};
      Plane + 8'd5:  code_o = {ik_pkg::Get, NX, Zero, Zero, 4'd0};
      Plane + 8'd6:  code_o = {ik_pkg::Get, NY, Zero, Zero, 4'd1};
      Plane + 8'd7:  code_o = {ik_pkg::Get, OX, Zero, Zero, 4'd2};
      Plane + 8'd8:  code_o = {ik_pkg::Get, OY, Zero, Zero, 4'd3};
      Plane + 8'd9:  code_o = {ik_pkg::Get, AX, Zero, Zero, 4'd4};
      Plane + 8'd10: code_o = {ik_pkg::Get, AY, Zero, Zero, 4'd5};
      Plane + 8'd11: code_o = {ik_pkg::Get, T0, Zero, Zero, 4'd6};
      Plane + 8'd12: code_o = {ik_pkg::Multiply, WX, T0, Ungain, ik_pkg::ByUnit};
      Plane + 8'd13: code_o = {ik_pkg::Subtract, WZ, WZ, Base, ik_pkg::None};
      Plane + 8'd14: code_o = {ik_pkg::Subtract, OffsetX, Zero, A1, ik_pkg::None};
      Plane + 8'd15: code_o = {ik_pkg::Add, OffsetY, Zero, Zero, ik_pkg::None};
      Plane + 8'd16: code_o = {ik_pkg::Add, T0, Upper, Forearm, ik_pkg::None};
      Plane + 8'd17: code_o = {ik_pkg::Subtract, T1, Upper, Forearm, ik_pkg::None};
      Plane + 8'd18: code_o = {ik_pkg::Multiply, Farthest2, T0, T0, ik_pkg::BySquare};
      Plane + 8'd19: code_o = {ik_pkg::Multiply, Nearest2, T1, T1, ik_pkg::BySquare};
      Plane + 8'd20: code_o = {ik_pkg::Multiply, Difference2, T0, T1, ik_pkg::BySquare};
      Plane + 8'd21: code_o = {ik_pkg::Multiply, T0, Upper, Upper, ik_pkg::BySquare};
      Plane + 8'd22: code_o = {ik_pkg::Multiply, T1, Forearm, Forearm, ik_pkg::BySquare};
      Plane + 8'd23: code_o = {ik_pkg::Add, Sum2, T0, T1, ik_pkg::None};
      Plane + 8'd24: code_o = jump(ik_pkg::IfSixR, HandOfSix);

      // Five axes: from the wrist centre to joint 4, pitch and theta_5.
      ToolOfFive + 8'd0:  code_o = {ik_pkg::Multiply, WY, AX, Ungain, ik_pkg::ByUnit};
      ToolOfFive + 8'd1:  code_o = {ik_pkg::Multiply, T0, A4, AZ, ik_pkg::ByUnit};
      ToolOfFive + 8'd2:  code_o = {ik_pkg::Add, OffsetX, OffsetX, T0, ik_pkg::None};
      ToolOfFive + 8'd3:  code_o = {ik_pkg::Subtract, WZ, Zero, WZ, ik_pkg::None};
      ToolOfFive + 8'd4:  code_o = {ik_pkg::Multiply, OffsetY, A4, WY, ik_pkg::ByUnit};
      ToolOfFive + 8'd5:  code_o = {ik_pkg::Subtract, T0, Zero, AZ, ik_pkg::None};
      ToolOfFive + 8'd6:  code_o = {ik_pkg::Subtract, T1, Zero, WY, ik_pkg::None};
      ToolOfFive + 8'd7:  code_o = {ik_pkg::LoadMain, Zero, T0, T1, ik_pkg::ZeroExact};
      ToolOfFive + 8'd8:  code_o = {ik_pkg::Vector, Pitch, Zero, Zero, ik_pkg::FlagNone};
      ToolOfFive + 8'd9:  code_o = {ik_pkg::Subtract, T0, Zero, OY, ik_pkg::None};
      ToolOfFive + 8'd10: code_o = {ik_pkg::Subtract, T1, Zero, NY, ik_pkg::None};
      ToolOfFive + 8'd11: code_o = {ik_pkg::LoadMain, Zero, T0, T1, ik_pkg::ZeroExact};
      ToolOfFive + 8'd12: code_o = {ik_pkg::Vector, Theta5, Zero, Zero, ik_pkg::FlagNone};
      ToolOfFive + 8'd13: code_o = jump(ik_pkg::Always, Shoulder);

      // Six axes: the rotation in the plane, with the gains of the other rows: z gets G, y G^2 and the other sign.
      HandOfSix + 8'd0:  code_o = {ik_pkg::Multiply, NZ, NZ, Gain, ik_pkg::ByUnit};
      HandOfSix + 8'd1:  code_o = {ik_pkg::Multiply, OZ, OZ, Gain, ik_pkg::ByUnit};
      HandOfSix + 8'd2:  code_o = {ik_pkg::Multiply, AZ, AZ, Gain, ik_pkg::ByUnit};
      HandOfSix + 8'd3:  code_o = {ik_pkg::Multiply, T0, NY, Gain, ik_pkg::ByUnit};
      HandOfSix + 8'd4:  code_o = {ik_pkg::Subtract, NY, Zero, T0, ik_pkg::None};
      HandOfSix + 8'd5:  code_o = {ik_pkg::Multiply, T0, OY, Gain, ik_pkg::ByUnit};
      HandOfSix + 8'd6:  code_o = {ik_pkg::Subtract, OY, Zero, T0, ik_pkg::None};
      HandOfSix + 8'd7:  code_o = {ik_pkg::Multiply, T0, AY, Gain, ik_pkg::ByUnit};
      HandOfSix + 8'd8:  code_o = {ik_pkg::Subtract, AY, Zero, T0, ik_pkg::None};

      // The triangle of the links: reach, area, and its angles.
      Shoulder + 8'd0:  code_o = {ik_pkg::Add, X, WX, OffsetX, ik_pkg::None};
      Shoulder + 8'd1:  code_o = {ik_pkg::Add, Y, WZ, OffsetY, ik_pkg::None};
      Shoulder + 8'd2:  code_o = {ik_pkg::Test, Zero, X, Y, ik_pkg::Far};
      Shoulder + 8'd3:  code_o = jump(ik_pkg::IfTrue, Next);
      Shoulder + 8'd4:  code_o = {ik_pkg::Multiply, T0, X, X, ik_pkg::BySquare};
      Shoulder + 8'd5:  code_o = {ik_pkg::Multiply, T1, Y, Y, ik_pkg::BySquare};
      Shoulder + 8'd6:  code_o = {ik_pkg::Add, Distance2, T0, T1, ik_pkg::None};
      Shoulder + 8'd7:  code_o = {ik_pkg::Subtract, ToOuter, Farthest2, Distance2, ik_pkg::None};
      Shoulder + 8'd8:  code_o = {ik_pkg::Subtract, ToInner, Distance2, Nearest2, ik_pkg::None};
      Shoulder + 8'd9:  code_o = {ik_pkg::Test, Zero, ToOuter, ToInner, ik_pkg::Reach};
      Shoulder + 8'd10: code_o = jump(ik_pkg::IfTrue, Next);
      Shoulder + 8'd11: code_o = {ik_pkg::Positive, ToOuter, ToOuter, Zero, ik_pkg::None};
      Shoulder + 8'd12: code_o = {ik_pkg::Positive, ToInner, ToInner, Zero, ik_pkg::None};
      Shoulder + 8'd13: code_o = {ik_pkg::Root, Area, ToOuter, ToInner, ik_pkg::None};
      Shoulder + 8'd14: code_o = {ik_pkg::Add, T0, Distance2, Difference2, ik_pkg::None};
      Shoulder + 8'd15: code_o = {ik_pkg::LoadMain, Zero, T0, Area, ik_pkg::ZeroExact};
      Shoulder + 8'd16: code_o = {ik_pkg::Vector, Beta, Zero, Zero, ik_pkg::FlagNone};
      Shoulder + 8'd17: code_o = {ik_pkg::Subtract, T0, Distance2, Sum2, ik_pkg::None};
      Shoulder + 8'd18: code_o = {ik_pkg::LoadMain, Zero, T0, Area, ik_pkg::ZeroExact};
      Shoulder + 8'd19: code_o = {ik_pkg::Vector, Delta, Zero, Zero, ik_pkg::FlagNone};
      Shoulder + 8'd20: code_o = {ik_pkg::LoadMain, Zero, X, Y, ik_pkg::ZeroLength};
      Shoulder + 8'd21: code_o = {ik_pkg::Vector, Gamma, Previous2, Zero, ik_pkg::FlagFolded};
      Shoulder + 8'd22: code_o = {ik_pkg::Select, Beta, Zero, Beta, ik_pkg::None};
      Shoulder + 8'd23: code_o = jump(ik_pkg::IfSixR, Elbow);
      Shoulder + 8'd24: code_o = {ik_pkg::Subtract, Beta, Zero, Beta, ik_pkg::None};
      Shoulder + 8'd25: code_o = {ik_pkg::Subtract, Delta, Zero, Delta, ik_pkg::None};

      // theta_2 and theta_3 of one elbow.
      Elbow + 8'd0:  code_o = {ik_pkg::Add, Theta2, Gamma, Beta, ik_pkg::None};
      Elbow + 8'd1:  code_o = {ik_pkg::Subtract, Theta3, Phi, Delta, ik_pkg::None};
      Elbow + 8'd2:  code_o = {ik_pkg::Result, Zero, Theta1, Zero, 4'd0};
      Elbow + 8'd3:  code_o = {ik_pkg::Result, Zero, Theta2, Zero, 4'd1};
      Elbow + 8'd4:  code_o = {ik_pkg::Result, Zero, Theta3, Zero, 4'd2};
      Elbow + 8'd5:  code_o = jump(ik_pkg::IfSixR, Wrist);
      Elbow + 8'd6:  code_o = {ik_pkg::Subtract, T0, Pitch, Theta2, ik_pkg::None};
      Elbow + 8'd7:  code_o = {ik_pkg::Subtract, T0, T0, Theta3, ik_pkg::None};
      Elbow + 8'd8:  code_o = {ik_pkg::Result, Zero, T0, Zero, 4'd3};
      Elbow + 8'd9:  code_o = {ik_pkg::Result, Zero, Theta5, Zero, 4'd4};
      Elbow + 8'd10: code_o = {ik_pkg::Result, Zero, Zero, Zero, 4'd5};
      Elbow + 8'd11: code_o = jump(ik_pkg::Always, Bend);

      // Six axes: W = R03^T R, then theta_4, and theta_5 and theta_6 of what theta_4 leaves.
      Wrist + 8'd0:  code_o = {ik_pkg::Add, T0, Theta2, Theta3, ik_pkg::None};
      Wrist + 8'd1:  code_o = {ik_pkg::LoadSlave, Zero, NX, NZ, 4'd0};
      Wrist + 8'd2:  code_o = {ik_pkg::LoadSlave, Zero, OX, OZ, 4'd1};
      Wrist + 8'd3:  code_o = {ik_pkg::LoadSlave, Zero, AX, AZ, 4'd2};
      Wrist + 8'd4:  code_o = {ik_pkg::Rotate, Zero, T0, Zero, ik_pkg::None};
      Wrist + 8'd5:  code_o = {ik_pkg::Get, N1, Zero, Zero, 4'd0};
      Wrist + 8'd6:  code_o = {ik_pkg::Get, O1, Zero, Zero, 4'd2};
      Wrist + 8'd7:  code_o = {ik_pkg::Get, H1, Zero, Zero, 4'd4};
      Wrist + 8'd8:  code_o = {ik_pkg::Get, T0, Zero, Zero, 4'd5};
      Wrist + 8'd9:  code_o = {ik_pkg::LoadMain, Zero, H1, AY, ik_pkg::ZeroWrist};
      Wrist + 8'd10: code_o = {ik_pkg::LoadSlave, Zero, N1, NY, 4'd0};
      Wrist + 8'd11: code_o = {ik_pkg::LoadSlave, Zero, O1, OY, 4'd1};
      Wrist + 8'd12: code_o = {ik_pkg::LoadSlave, Zero, H1, AY, 4'd2};
      Wrist + 8'd13: code_o = {ik_pkg::Vector, T1, Previous4, Zero, ik_pkg::FlagWrist};
      Wrist + 8'd14: code_o = {ik_pkg::Result, Zero, T1, Zero, 4'd3};
      Wrist + 8'd15: code_o = {ik_pkg::Get, H1, Zero, Zero, 4'd4};
      Wrist + 8'd16: code_o = {ik_pkg::Get, O1, Zero, Zero, 4'd3};
      Wrist + 8'd17: code_o = {ik_pkg::Get, N1, Zero, Zero, 4'd1};
      Wrist + 8'd18: code_o = {ik_pkg::Multiply, T0, T0, Gain, ik_pkg::ByUnit};
      Wrist + 8'd19: code_o = {ik_pkg::Subtract, T0, Zero, T0, ik_pkg::None};
      Wrist + 8'd20: code_o = {ik_pkg::LoadMain, Zero, T0, H1, ik_pkg::ZeroExact};
      Wrist + 8'd21: code_o = {ik_pkg::Vector, T0, Zero, Zero, ik_pkg::FlagNone};
      Wrist + 8'd22: code_o = {ik_pkg::Result, Zero, T0, Zero, 4'd4};
      Wrist + 8'd23: code_o = {ik_pkg::LoadMain, Zero, O1, N1, ik_pkg::ZeroExact};
      Wrist + 8'd24: code_o = {ik_pkg::Vector, T0, Zero, Zero, ik_pkg::FlagNone};
      Wrist + 8'd25: code_o = {ik_pkg::Result, Zero, T0, Zero, 4'd5};

      // The other elbow, then the back shoulder.
      Bend + 8'd0:  code_o = {ik_pkg::Subtract, Beta, Zero, Beta, ik_pkg::None};
      Bend + 8'd1:  code_o = {ik_pkg::Subtract, Delta, Zero, Delta, ik_pkg::None};
      Bend + 8'd2:  code_o = jump(ik_pkg::IfFirstElbow, Elbow);

      Next + 8'd0:  code_o = jump(ik_pkg::IfSecondShoulder, Stop);
      Next + 8'd1:  code_o = {ik_pkg::Add, Theta1, Theta1, HalfTurn, ik_pkg::None};
      Next + 8'd2:  code_o = {ik_pkg::Subtract, WX, Zero, WX, ik_pkg::None};
      Next + 8'd3:  code_o = jump(ik_pkg::IfSixR, BackOfSix);
      Next + 8'd4:  code_o = {ik_pkg::Subtract, OffsetY, Zero, OffsetY, ik_pkg::None};
      Next + 8'd5:  code_o = {ik_pkg::Subtract, Pitch, Zero, Pitch, ik_pkg::None};
      Next + 8'd6:  code_o = {ik_pkg::Add, Theta5, Theta5, HalfTurn, ik_pkg::None};
      Next + 8'd7:  code_o = jump(ik_pkg::Always, Shoulder);

      BackOfSix + 8'd0:  code_o = {ik_pkg::Subtract, NX, Zero, NX, ik_pkg::None};
      BackOfSix + 8'd1:  code_o = {ik_pkg::Subtract, OX, Zero, OX, ik_pkg::None};
      BackOfSix + 8'd2:  code_o = {ik_pkg::Subtract, AX, Zero, AX, ik_pkg::None};
      BackOfSix + 8'd3:  code_o = {ik_pkg::Subtract, NY, Zero, NY, ik_pkg::None};
      BackOfSix + 8'd4:  code_o = {ik_pkg::Subtract, OY, Zero, OY, ik_pkg::None};
      BackOfSix + 8'd5:  code_o = {ik_pkg::Subtract, AY, Zero, AY, ik_pkg::None};
      BackOfSix + 8'd6:  code_o = jump(ik_pkg::Always, Shoulder);

      default: code_o = {ik_pkg::Stop, 22'd0};
    endcase
  end

endmodule
