// Operations of ik_core and their arguments. a and b are the operands; the result goes to the destination.
package ik_pkg;

  localparam logic [3:0] Add       = 4'd0;   // a + b
  localparam logic [3:0] Subtract  = 4'd1;   // a - b
  localparam logic [3:0] Positive  = 4'd2;   // a, or 0 if a < 0
  localparam logic [3:0] Select    = 4'd3;   // a if the condition holds, otherwise b
  localparam logic [3:0] Get       = 4'd4;   // coordinate of a slave lane: 2 lane + (y, not x)
  localparam logic [3:0] Multiply  = 4'd5;   // a * b, see ik_multiplier
  localparam logic [3:0] Root      = 4'd6;   // integer root of a * b, both not negative
  localparam logic [3:0] LoadMain  = 4'd7;   // main lane (a, b), with the bound of zero
  localparam logic [3:0] LoadSlave = 4'd8;   // slave lane (a, b), with its number
  localparam logic [3:0] Vector    = 4'd9;   // angle of the main lane; a if it is zero, which is then the condition
  localparam logic [3:0] Rotate    = 4'd10;  // turns the slave lanes by -a; no result
  localparam logic [3:0] Result    = 4'd11;  // a is an angle of the joint, from 0, of both branches of this elbow
  localparam logic [3:0] Test      = 4'd12;  // sets the condition
  localparam logic [3:0] Jump      = 4'd13;
  localparam logic [3:0] Stop      = 4'd14;

  localparam logic [3:0] None = 4'd0;

  // Multiply: the format of the result.
  localparam logic [3:0] ByUnit   = 4'd0;
  localparam logic [3:0] BySquare = 4'd1;

  // LoadMain: zero is below 2^0, 2^6, 2^11.
  localparam logic [3:0] ZeroExact  = 4'd0;
  localparam logic [3:0] ZeroLength = 4'd1;
  localparam logic [3:0] ZeroWrist  = 4'd2;

  // Vector: the flag of the results that is set if the main lane is zero.
  localparam logic [3:0] FlagNone     = 4'd0;
  localparam logic [3:0] FlagShoulder = 4'd1;
  localparam logic [3:0] FlagFolded   = 4'd2;
  localparam logic [3:0] FlagWrist    = 4'd3;

  // Test. Near: both are below 2^20. Far: one is not below 2^30. Reach: one is below minus the tolerance; if none is,
  // the flags clamped and elbow are set.
  localparam logic [3:0] Negative   = 4'd0;  // a < 0
  localparam logic [3:0] Near       = 4'd1;
  localparam logic [3:0] AndNotNear = 4'd2;  // and the condition held before
  localparam logic [3:0] Far        = 4'd3;
  localparam logic [3:0] Reach      = 4'd4;

  // Jump. IfFirstElbow makes the elbow the second one if it jumps, otherwise the first one. IfSecondShoulder makes the
  // shoulder the second one if it does not jump.
  localparam logic [3:0] Always           = 4'd0;
  localparam logic [3:0] IfFiveR          = 4'd1;
  localparam logic [3:0] IfSixR           = 4'd2;
  localparam logic [3:0] IfTrue           = 4'd3;
  localparam logic [3:0] IfFirstElbow     = 4'd4;
  localparam logic [3:0] IfSecondShoulder = 4'd5;

endpackage
