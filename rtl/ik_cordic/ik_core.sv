// Core of ik_cordic: executes ik_program on a scratch memory of 64 words of 48 bits, with an adder, a multiplier, an
// integer root and a CORDIC. It has no bus port.
//
// A start copies the inputs to the first words of the memory, one per clock. Each step then takes one clock, but for
// those of the multiplier, the root and the CORDIC, which take until the unit is done.
`include "assert.svh"
`include "ik_cordic_reg_types.svh"

module ik_core (
  input  logic              clk_i,
  input  logic              rst_ni,    // synchronous
  output logic              active_o,  // clock request; 0: an edge changes no flop unless a register has just changed

  /* verilator tracing_off */
  input  ik_cordic_reg2hw_t reg2hw_i,
  output ik_cordic_hw2reg_t hw2reg_o,
  /* verilator tracing_on */

  output logic              irq_o
);

  // Words that a start copies, in the order of ik_program. The last four are constants: 0, G, 1/G and half a turn.
  localparam int Inputs = 26;
  logic [Inputs*32-1:0] inputs;
  assign inputs = {
    32'h8000_0000, 32'd652032874, 32'd1768195363, 32'd0, reg2hw_i.previous_angle, reg2hw_i.phi_angle,
    reg2hw_i.hand_length, reg2hw_i.a4_length, 3'b000, reg2hw_i.forearm_length, 3'b000, reg2hw_i.a2_length,
    reg2hw_i.d1_length, reg2hw_i.a1_length, reg2hw_i.position_coordinate, reg2hw_i.rotation_entry
  };

  typedef enum logic [1:0] {Idle, Copy, Step, Wait} state_e;
  state_e      state_q;
  logic [7:0]  step_q;      // while Copy the number of words
  logic        five_r_q, done_q, event_q, refused_q, condition_q, shoulder_q, elbow_q;
  logic [11:0] cycles_q;
  logic        start, refused;
  assign start    = reg2hw_i.ctrl_start && state_q == Idle;
  assign refused  = reg2hw_i.ctrl_start && state_q != Idle;

  // The present step.
  logic [25:0] code;
  logic [3:0]  operation, argument;
  logic [5:0]  destination;
  assign operation   = code[25:22];
  assign destination = code[21:16];
  assign argument    = code[3:0];

  ik_program u_program (.step_i(step_q), .code_o(code));

  logic [47:0] memory [64];
  logic signed [47:0] a, b;
  assign a = memory[code[15:10]];
  assign b = memory[code[9:4]];

  // Units.
  logic               first;  // clock of a step
  logic               multiplying, rooting, turning;
  logic               multiplied, rooted, turned, zero;
  logic signed [47:0] product, coordinate;
  logic        [85:0] square;
  logic        [42:0] root;
  logic        [31:0] angle;
  logic        [3:0]  slave;
  assign first    = state_q == Step;
  assign slave    = first && operation == ik_pkg::LoadSlave ? 4'd1 << argument[1:0] : '0;

  ik_multiplier u_multiplier (
    .clk_i, .rst_ni, .start_i(first && (operation == ik_pkg::Multiply || operation == ik_pkg::Root)),
    .shift_i(argument[0]), .a_i(a), .b_i(b), .busy_o(multiplying), .done_o(multiplied), .product_o(square),
    .rounded_o(product)
  );

  ik_root u_root (
    .clk_i, .rst_ni, .start_i(multiplied && operation == ik_pkg::Root), .square_i(square), .busy_o(rooting),
    .done_o(rooted), .root_o(root)
  );

  cordic u_cordic (
    .clk_i, .rst_ni, .load_main_i(first && operation == ik_pkg::LoadMain), .zero_below_i(argument[1:0]),
    .load_slave_i(slave), .x_i(a), .y_i(b),
    .start_i(first && (operation == ik_pkg::Vector || operation == ik_pkg::Rotate)),
    .vector_i(operation == ik_pkg::Vector), .angle_i(a[31:0]), .busy_o(turning), .done_o(turned),
    .angle_o(angle), .zero_o(zero), .slave_i(argument[2:1]), .y_not_x_i(argument[0]), .coordinate_o(coordinate)
  );

  // One clock after the event, or what enables it.
  logic interrupt;
  assign interrupt = reg2hw_i.event_done && reg2hw_i.ctrl_irq;

  // One flop, because a simulator reads it in every clock. What a write changes is used while the bus port of the block
  // still requests the clock for the response: a start, the interrupt and its enable.
  logic awake_q;
  assign active_o = awake_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      irq_o   <= 1'b0;
      awake_q <= 1'b0;
    end else begin
      irq_o   <= interrupt;
      awake_q <= reg2hw_i.ctrl_start || state_q != Idle || event_q || irq_o != interrupt || multiplying || rooting ||
                 turning;
    end
  end

  // The end of a step, and its result.
  logic               long, finished;
  logic signed [47:0] result, positive, turn;
  assign positive = a[47] ? '0 : a;
  assign turn     = {{16{angle[31]}}, angle};
  always_comb begin
    long     = 1'b0;
    finished = turned;
    result   = a + b;
    case (operation)
      ik_pkg::Subtract: result = a - b;
      ik_pkg::Positive: result = positive;
      ik_pkg::Select:   result = condition_q ? a : b;
      ik_pkg::Get:      result = coordinate;
      ik_pkg::Multiply: begin
        long     = 1'b1;
        finished = multiplied;
        result   = product;
      end
      ik_pkg::Root: begin
        long     = 1'b1;
        finished = rooted;
        result   = {5'd0, root};
      end
      ik_pkg::Vector: begin
        long   = 1'b1;
        result = turn;
      end
      ik_pkg::Rotate: long = 1'b1;
      default: ;
    endcase
  end

  logic last;  // clock of a step
  assign last = (first && !long) || (state_q == Wait && finished);

  // Tests.
  logic negative, near, far, beyond, tested;
  assign negative = a[47];
  assign near   = a[47:20] == {28{a[47]}} && b[47:20] == {28{b[47]}};
  assign far    = a[47:30] != {18{a[47]}} || b[47:30] != {18{b[47]}};
  assign beyond = (a[47] && a[47:18] != '1) || (b[47] && b[47:18] != '1);
  always_comb begin
    case (argument)
      ik_pkg::Negative:   tested = negative;
      ik_pkg::Near:       tested = near;
      ik_pkg::AndNotNear: tested = condition_q && !near;
      ik_pkg::Far:        tested = far;
      default:            tested = beyond;
    endcase
  end

  logic jump;
  always_comb begin
    case (argument)
      ik_pkg::Always:       jump = 1'b1;
      ik_pkg::IfFiveR:      jump = five_r_q;
      ik_pkg::IfSixR:       jump = !five_r_q;
      ik_pkg::IfTrue:       jump = condition_q;
      ik_pkg::IfFirstElbow: jump = !elbow_q;
      default:              jump = shoulder_q;
    endcase
  end

  logic writes, vector_end, reached;
  assign vector_end = last && operation == ik_pkg::Vector;
  assign reached  = last && operation == ik_pkg::Test && argument == ik_pkg::Reach && !beyond;
  assign writes   = last && (operation <= ik_pkg::Root || operation == ik_pkg::Vector);

  always_ff @(posedge clk_i) begin
    if (state_q == Copy) memory[step_q[5:0]] <= {{16{inputs[{step_q[4:0], 5'd31}]}}, inputs[{step_q[4:0], 5'd0} +: 32]};
    else if (writes) memory[destination] <= result;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q     <= Idle;
      step_q      <= '0;
      five_r_q    <= 1'b0;
      done_q      <= 1'b0;
      event_q     <= 1'b0;
      refused_q   <= 1'b0;
      condition_q <= 1'b0;
      shoulder_q  <= 1'b0;
      elbow_q     <= 1'b0;
      cycles_q    <= '0;
    end else begin
      event_q <= first && operation == ik_pkg::Stop;
      if (refused) refused_q <= 1'b1;
      if (start) begin
        state_q    <= Copy;
        step_q     <= '0;
        five_r_q   <= reg2hw_i.ctrl_five_r;
        done_q     <= 1'b0;
        refused_q  <= 1'b0;
        cycles_q   <= '0;
        shoulder_q <= 1'b0;
        elbow_q    <= 1'b0;
      end else if (state_q != Idle) begin
        cycles_q <= cycles_q + 12'd1;
      end
      if (state_q == Copy) begin
        step_q <= step_q + 8'd1;
        if (step_q == 8'(Inputs - 1)) begin
          step_q  <= '0;
          state_q <= Step;
        end
      end
      if (first && long) state_q <= Wait;
      if (last) begin
        state_q <= Step;
        step_q  <= step_q + 8'd1;
        if (operation == ik_pkg::Vector) condition_q <= zero;
        if (operation == ik_pkg::Test) condition_q <= tested;
        if (operation == ik_pkg::Jump) begin
          if (jump) step_q <= code[11:4];
          if (argument == ik_pkg::IfFirstElbow) elbow_q <= jump;
          if (argument == ik_pkg::IfSecondShoulder) shoulder_q <= 1'b1;
        end
        if (operation == ik_pkg::Stop) begin
          state_q <= Idle;
          done_q  <= 1'b1;
        end
      end
    end
  end

  ik_results u_results (
    .clk_i, .rst_ni, .clear_i(start), .five_r_i(five_r_q), .shoulder_i(shoulder_q), .elbow_i(elbow_q),
    .write_i(last && operation == ik_pkg::Result), .joint_i(argument[2:0]), .angle_i(a[31:0]),
    .flag_i((vector_end && zero) || reached),
    .flag_shoulder_i(vector_end && argument == ik_pkg::FlagShoulder),
    .flag_folded_i(vector_end && argument == ik_pkg::FlagFolded),
    .flag_wrist_i(vector_end && argument == ik_pkg::FlagWrist),
    .flag_clamped_i(reached && (a[47] || b[47])),
    .flag_elbow_i(reached && (a[47] || b[47] || a[47:18] == '0 || b[47:18] == '0)),
    .valid_o(hw2reg_o.branches_valid), .shoulder_o(hw2reg_o.flags_shoulder), .elbow_o(hw2reg_o.flags_elbow),
    .clamped_o(hw2reg_o.flags_clamped), .folded_o(hw2reg_o.flags_folded), .wrist_o(hw2reg_o.flags_wrist),
    .theta_o(hw2reg_o.theta_angle)
  );

  assign hw2reg_o.status_busy       = state_q != Idle;
  assign hw2reg_o.status_done       = done_q;
  assign hw2reg_o.status_refused    = refused_q;
  assign hw2reg_o.event_done_set    = event_q;
  assign hw2reg_o.cycles_value      = cycles_q;

  `ASSERT(EndsInTime, cycles_q < 12'd2500)
  `ASSERT(RootOfNoNegativeWord, !(last && operation == ik_pkg::Root) || !a[47] && !b[47])

endmodule
