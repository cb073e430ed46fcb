// pulse_gen emits all pulses of a tick that is long enough, for every count, direction, set-up and hold time, and for
// every end of the tick before.
//
// T is tick_cycles_i. B is the number of clocks in which the axis is blocked at the start of the tick: `blocked`, known
// in its first clock. The next trigger comes T or more clocks after that of the tick. Set-up and hold time do not
// change in the tick, and no stop comes in it or with its trigger. Then
//   T >= 12|count| + B      all pulses have risen six clocks before the end, and the last one falls on the trigger edge
//   T >= 12|count| + B - 5  nothing is unfinished at the trigger
// With one clock less a pulse can be unfinished: see OneClockLessIsTooShort.
//
// The proof. With b clocks left, r edges left, window w and increment i, the modulo accumulator keeps
//   acc = r*w - i*b
// from its start (acc = 0, r = i, b = w) on. Since acc < w, r is 1 when b is 1. An induction step cannot multiply such
// numbers. Therefore part[k] = (r>>k)*w - (i>>k)*b is a register: an addition adds i>>k, and an edge subtracts w if it
// changes r>>k. All parts stay between -w and w, and neighbours differ by one bit of r and of i:
//   part[0] = acc,  part[k] = 2 part[k+1] + r[k]*w - i[k]*b,  part[9] = 0
// If w is below 6i, edges wait for the minimum width. Then there are at most 6 clocks from edge to edge.
`include "assert.svh"
`default_nettype none

module pulse_gen_all_proof (
  input wire               clk_i,
  input wire               rst_ni,
  input wire               trigger_i,
  input wire signed [8:0]  count_i,
  input wire               stop_i,
  input wire        [11:0] tick_cycles_i,
  input wire        [9:0]  dir_setup_i,
  input wire        [9:0]  dir_hold_i
);

  localparam int Bits = 9, Width = 15;  // of r and i; of a part with all its terms

  logic               step_o, dir_o;
  logic signed [31:0] emitted_o;
  logic signed [8:0]  unfinished_o;
  pulse_gen u_dut (.*);

  // The state of the module: `flatten` connects these nets to its registers of the same names.
  (* hierconn *) wire        \u_dut.running_q , \u_dut.own_pulse_q ;
  (* hierconn *) wire [8:0]  \u_dut.increment_q ;
  (* hierconn *) wire [12:0] \u_dut.window_q , \u_dut.acc_q ;
  (* hierconn *) wire [9:0]  \u_dut.since_edge_q , \u_dut.setup_q ;
  logic        running, own;
  logic [8:0]  increment;
  logic [12:0] window, acc;
  logic [9:0]  since, setup;
  assign running   = \u_dut.running_q ;
  assign own       = step_o && \u_dut.own_pulse_q ;
  assign increment = \u_dut.increment_q ;
  assign window    = \u_dut.window_q ;
  assign acc       = \u_dut.acc_q ;
  assign since     = \u_dut.since_edge_q ;
  assign setup     = \u_dut.setup_q ;

  `RESET_FIRST

  `ASSUME(CountIsLimited, count_i >= -9'sd200 && count_i <= 9'sd200)

  // The clocks in which the axis will be blocked, this one included: by a high pulse of the tick before, until it has
  // its minimum width; then by a reversal, for the rest of the hold time (one clock or more) and for the set-up time;
  // by the rest of a set-up time of the tick before.
  logic        foreign, turns, waits;
  logic [12:0] turn_at, blocked;
  assign foreign = step_o && !own;
  assign turns   = unfinished_o != '0 && dir_o == unfinished_o[8] && !own;
  assign waits   = !own && (step_o || setup != '0 || turns);
  always_comb begin
    turn_at = step_o ? 13'(dir_hold_i) : (dir_hold_i > since) ? 13'(dir_hold_i - since) + 13'd1 : 13'd1;
    if (turn_at <= 13'(setup)) turn_at = 13'(setup) + 13'd1;
    blocked = turns ? turn_at + 13'(dir_setup_i) : 13'(setup);
    if (foreign) blocked = blocked + ((since < 10'd6) ? 13'd7 - 13'(since) : 13'd1);
  end

  logic [12:0] shortest;  // window: two minimum widths per pulse
  assign shortest = {2'b00, increment, 2'b00} + {3'b000, increment, 1'b0};

  // `good` and `roomy`: the tick has at least 12|count| + B - 5, or 12|count| + B, clocks. Decided in its first clock.
  logic        begins_q, stopped_q, steady, good, roomy;
  logic        good_q, roomy_q, tight_q, short_q;
  logic [9:0]  dir_setup_q, dir_hold_q;
  logic [11:0] left_q;  // clocks until tick_cycles_i have passed, this one included
  assign steady = begins_q ? !stopped_q : !stopped_q && dir_setup_i == dir_setup_q && dir_hold_i == dir_hold_q;
  assign good   = steady && (begins_q ? 13'(left_q) + 13'd5 >= shortest + blocked : good_q);
  assign roomy  = good && (begins_q ? 13'(left_q) >= shortest + blocked : roomy_q);
  always_ff @(posedge clk_i) begin
    begins_q    <= rst_ni && trigger_i;
    stopped_q   <= stop_i;
    good_q      <= rst_ni && good;
    roomy_q     <= rst_ni && roomy;
    tight_q     <= rst_ni && steady && (begins_q ? 13'(left_q) + 13'd5 == shortest + blocked : tight_q);
    short_q     <= rst_ni && steady && (begins_q ? 13'(left_q) + 13'd6 == shortest + blocked : short_q);
    dir_setup_q <= dir_setup_i;
    dir_hold_q  <= dir_hold_i;
    if (!rst_ni) left_q <= '0;
    else if (trigger_i) left_q <= tick_cycles_i;
    else if (left_q != '0) left_q <= left_q - 12'd1;
  end

  logic [8:0] pulses, edges;  // left
  assign pulses = unfinished_o[8] ? 9'(-unfinished_o) : 9'(unfinished_o);
  assign edges  = {pulses[7:0], 1'b0} + 9'(own);

  logic       due, comes;  // an edge: the accumulator overflows; it is wide enough, too
  logic [2:0] phase_q;     // clocks since the last edge, or since the axis is not blocked, including this one; up to 6
  assign due   = !waits && 14'(acc) + 14'(increment) >= 14'(window);
  assign comes = due && since >= 10'd6 && (step_o || !(trigger_i || stop_i));
  always_ff @(posedge clk_i) begin
    if (!rst_ni || trigger_i || waits || comes) phase_q <= 3'd1;
    else if (phase_q < 3'd6) phase_q <= phase_q + 3'd1;
  end
  logic [12:0] phases;     // increment times phase_q
  assign phases = (phase_q[0] ? 13'(increment) : '0) + (phase_q[1] ? {3'b000, increment, 1'b0} : '0) +
                  (phase_q[2] ? {2'b00, increment, 2'b00} : '0);

  // A tick counts its edges and, when the axis is not blocked, its additions.
  logic [8:0]  edges_q, edges_next;
  logic [11:0] left_next;
  logic [12:0] gone_q, gone_next;  // window - left_q
  assign edges_next = edges_q - 9'(comes);
  assign left_next  = left_q - 12'd1;
  assign gone_next  = gone_q + 13'd1;
  always_ff @(posedge clk_i) begin
    if (trigger_i) edges_q <= {count_i[8] ? 8'(-count_i) : 8'(count_i), 1'b0};
    else if (!waits) edges_q <= edges_next;
    gone_q <= (trigger_i || waits) ? '0 : gone_next;
  end

  // The parts in this clock, after its addition, and after its edge.
  logic [Width-1:0]          wide;  // window
  logic [Width*(Bits+1)-1:0] part, part_added, part_next;
  assign wide = Width'(window);
  for (genvar k = 0; k <= Bits; k++) begin : gen_part
    logic [Width-1:0] part_q, added;
    if (k == 0) assign part_q = Width'(acc);
    else if (k == Bits) assign part_q = '0;
    else always_ff @(posedge clk_i) part_q <= (trigger_i || waits) ? '0 : part_next[Width*k +: Width];
    assign added = (k == Bits) ? '0 : part_q + Width'(increment >> k);
    assign part[Width*k +: Width]       = part_q;
    assign part_added[Width*k +: Width] = added;
    assign part_next[Width*k +: Width]  =
        (k != Bits && comes && (edges_q & 9'((1 << k) - 1)) == '0) ? added - wide : added;
  end

  logic blocked_now, free_now;
  assign blocked_now = good && running && waits;
  assign free_now    = good && running && !waits;

  // While the axis is blocked, `blocked`, window and time count down together. Later the window stands.
  logic [12:0] blocked_q;
  always_ff @(posedge clk_i) blocked_q <= waits ? blocked - 13'd1 : '0;
  `ASSERT(BlockedCountsDown, !(good && running && !begins_q) || blocked_q == (waits ? blocked : '0))
  `ASSERT(NothingIsLostWhileBlocked, !blocked_now || (window == 13'(left_q) && edges == increment && acc == '0))
  `ASSERT(WindowIsWideEnough, !(good && running) || window + 13'd5 >= shortest + (waits ? blocked : '0))
  `ASSERT(RoomIsKept, !(good && running) || roomy == (window >= shortest + (waits ? blocked : '0)))
  `ASSERT(OwnPulsesAreNotBlocked, !(good && running && \u_dut.own_pulse_q ) || setup == '0)
  `ASSERT(PhaseIsPartOfTheWidth, !free_now || (phase_q != '0 && phase_q <= 3'd6 && 10'(phase_q) <= since))

  // With room: no edge waits, and the parts prove that the last edge is due in the last clock.
  `ASSERT(NoEdgeWaits, !(free_now && roomy) || phase_q == 3'd6 || acc < phases)
  `ASSERT(TimeIsWithinTheWindow, !(free_now && roomy) || 13'(left_q) <= window)
  logic time_adds_up;
  assign time_adds_up = edges_q != '0 && left_q != '0 && gone_q < window && !window[12] &&
                        gone_q + 13'(left_q) == window;
  `ASSERT(TimeIsLeftOrGone, !(free_now && roomy) || time_adds_up)
  for (genvar k = 0; k < Bits; k++) begin : gen_check
    logic [Width-1:0] now, added, next;  // r[k]*w - i[k]*b
    logic             differ, differ_added, differ_next;
    assign now   = increment[k] ? (edges_q[k] ? Width'(gone_q) : -(Width'(left_q))) : (edges_q[k] ? wide : '0);
    assign added = increment[k] ? (edges_q[k] ? Width'(gone_next) : -(Width'(left_next))) : (edges_q[k] ? wide : '0);
    assign next  = increment[k] ? (edges_next[k] ? Width'(gone_next) : -(Width'(left_next)))
                                : (edges_next[k] ? wide : '0);
    assign differ       = part[Width*k +: Width] != {part[Width*(k+1) +: Width-1], 1'b0} + now;
    assign differ_added = part_added[Width*k +: Width] != {part_added[Width*(k+1) +: Width-1], 1'b0} + added;
    assign differ_next  = part_next[Width*k +: Width] != {part_next[Width*(k+1) +: Width-1], 1'b0} + next;
    `ASSERT(AnAdditionKeepsTheRelation, !time_adds_up || differ || !differ_added)
    `ASSERT(AnEdgeKeepsTheRelation, !time_adds_up || differ_added || !differ_next)
    `ASSERT(PartsDifferByOneBit, !(free_now && roomy) || !differ)
    `ASSERT(PartIsWithinTheWindow, !(free_now && roomy) ||
            ($signed(part[Width*k +: Width]) < $signed(wide) && $signed(part[Width*k +: Width]) > -$signed(wide)))
  end

  // Without room: an edge comes at least every six clocks, and the time suffices for that.
  `ASSERT(AnEdgeInSixClocks, !(free_now && !roomy) || due || acc + 13'(increment) >= phases)
  `ASSERT(TimeForTheRest, !(free_now && !roomy) ||
          14'(left_q) + 14'd4 + 14'(phase_q) >= {3'b000, edges, 2'b00} + {4'b0000, edges, 1'b0})

  `ASSERT(EdgesAreThoseOfTheCommand, !(good && running) ||
          (edges == edges_q && edges <= increment && pulses <= 9'd200 && increment <= 9'd400))
  `ASSERT(HighSinceAClock, !step_o || since != '0)
  `ASSERT(RunsUntilAllIsEmitted, !good || running || unfinished_o == '0)

  // The statements. `left_q` is 1 at a trigger after T clocks, and 0 at a later one.
  logic ended_q;
  always_ff @(posedge clk_i) ended_q <= rst_ni && roomy && running && left_q == 12'd1;
  `ASSERT(NothingIsUnfinishedAtTheTrigger, !(good && left_q <= 12'd1) || unfinished_o == '0)
  `ASSERT(NothingIsUnfinishedSixClocksBefore, !(roomy && left_q <= 12'd6) || unfinished_o == '0)
  `ASSERT(LastPulseFallsOnTheTriggerEdge, !ended_q || !step_o)

  // B in plain numbers: a high pulse of the tick before blocks five clocks or less, a reversal for its hold and set-up
  // times. Therefore T >= 12|count| + these times is enough, unless the set-up time of the tick before still runs.
  logic [12:0] reversal;
  assign reversal = turns ? ((dir_hold_i == '0) ? 13'd1 : 13'(dir_hold_i)) + 13'(dir_setup_i) : '0;
  `ASSERT(TwelveClocksPerPulseAndTheReversalAreEnough,
          !(begins_q && steady && setup == '0 && 13'(left_q) >= shortest + reversal) || good)
  `ASSERT(AHighPulseBlocksFiveClocksAtMost, !begins_q || blocked <= reversal + 13'd5 || setup != '0)

  `REACH(AllIsEmittedAtTheLimit, tight_q && steady && turned_q && !begins_q && left_q == 12'd1 && unfinished_o == '0)
  `REACH(OneClockLessIsTooShort, short_q && steady && !begins_q && left_q == 12'd1 && unfinished_o != '0)
  `REACH(LastPulseFalls, ended_q && turned_q && !begins_q)
  `REACH(LargestCommand, good && begins_q && !roomy && foreign && turns && unfinished_o == 9'sd200)

  logic turned_q;  // this tick began with a reversal behind a high pulse
  always_ff @(posedge clk_i) begin
    if (!rst_ni) turned_q <= 1'b0;
    else if (begins_q) turned_q <= turns && foreign && dir_hold_i == 10'd2 && dir_setup_i == 10'd1;
  end

endmodule

`default_nettype wire
