// Debounce filter for `Lines` synchronised one-bit lines. A line counts the samples that differ from its output and
// accepts the new level at the count of `time_i`; the mode says what a sample does that agrees with the output again:
//
//   restart (mode_i = 0)   it clears the count (Vo 2021, Figure 4): a level is accepted when it has been stable for
//                          `time_i` cycles. A line that bounces at least once in every `time_i` cycles never is.
//   up/down (mode_i = 1)   it takes one off the count: a counter that saturates at 0 and at `time_i` and moves the
//                          output at its ends. N samples against a new level delay it by 2 N cycles at most.
//
// Both pass clean levels of at least `time_i` cycles with the same delay, and drop shorter ones between long rests.
//
// While a line agrees with its output and its count is 0 nothing moves, so an idle line switches no flop. The counters
// are stored by bit position: count_q[k] holds bit k of every counter, so eight vector steps count all lines at once.
//
// After reset a line is unknown, and nothing is reported. The output is the candidate for its level: samples that agree
// count, and the line is known at the count of `time_i`; the level found there was never an edge. A sample that differs
// clears the count and becomes the candidate; in up/down mode it takes one off, and becomes the candidate at 0.
`include "assert.svh"

module debounce #(
  parameter int Lines = 1
) (
  input  logic             clk_i,
  input  logic             rst_ni,    // synchronous
  input  logic             mode_i,    // 0 restart, 1 up/down; a change takes effect at once, counts go on
  input  logic [7:0]       time_i,    // cycles; 0 and 1 accept the first sample; compared in every sample that counts
  input  logic             valid_i,   // level_i carries real levels; low while the synchroniser fills after reset
  input  logic [Lines-1:0] level_i,   // in this clock domain
  output logic [Lines-1:0] level_o,   // accepted level; follows a lasting change of level_i after `time_i` cycles
  output logic [Lines-1:0] known_o,   // level_o is an accepted level
  output logic [Lines-1:0] glitch_o   // one cycle: a change of a known line did not last and was dropped
);

  localparam int CountBits = 8;  // as time_i

  logic [Lines-1:0] count_q [CountBits];
  logic [Lines-1:0] counting_q;  // lines whose counter is not 0

  // A known line counts while it differs from its output, an unknown one while it agrees with it.
  logic [Lines-1:0] differs, counts;
  assign differs = level_i ^ level_o;
  assign counts  = ~(differs ^ known_o);

  // The sample takes one off the count.
  logic [Lines-1:0] down;
  assign down = counting_q & ~counts & {Lines{mode_i}};

  // Scratch of the clocked process, written before it is read.
  logic [CountBits-1:0] last;    // count of the last cycle that is needed
  logic [Lines-1:0]     done;    // this is that cycle
  logic [Lines-1:0]     moves;   // the count goes on, up or down; the others are cleared
  logic [Lines-1:0]     carry;   // or borrow
  logic [Lines-1:0]     next, left;

  /* verilator lint_off BLKSEQ */
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      level_o    <= '0;
      known_o    <= '0;
      glitch_o   <= '0;
      counting_q <= '0;
      for (int k = 0; k < CountBits; k++) count_q[k] <= '0;
    end else if (!valid_i) begin
      level_o <= level_i;
    end else if ((counts | counting_q) != '0 || known_o != '1) begin
      // count >= last, from the lowest bit upwards: also right when `time_i` has just been lowered.
      last = (time_i == 8'd0) ? 8'd0 : time_i - 8'd1;
      done = '1;
      for (int k = 0; k < CountBits; k++) done = last[k] ? (count_q[k] & done) : (count_q[k] | done);
      done = done & counts;

      moves = (counts & ~done) | down;
      carry = moves;
      left  = '0;
      for (int k = 0; k < CountBits; k++) begin
        next = (count_q[k] ^ carry) & moves;
        count_q[k] <= next;
        left  = left | next;
        carry = carry & (count_q[k] ^ down);
      end

      counting_q <= left;
      level_o    <= level_o ^ (differs & (done | ~(known_o | down)));
      known_o    <= known_o | done;
      glitch_o   <= known_o & counting_q & ~differs & ~left;
    end else if (glitch_o != '0) begin
      glitch_o <= '0;
    end
  end
  /* verilator lint_on BLKSEQ */

`ifdef ASSERT_ON
  // The clock edge before.
  logic [Lines-1:0] input_q, output_q, known_q, waiting_q;
  always_ff @(posedge clk_i) begin
    input_q   <= level_i;
    output_q  <= level_o;
    known_q   <= rst_ni ? known_o : '0;
    waiting_q <= counting_q | {Lines{time_i <= 8'd1}};  // 0 and 1 need no count
  end

  logic [Lines-1:0] nonzero, accepted;
  always_comb begin
    nonzero = '0;
    for (int k = 0; k < CountBits; k++) nonzero = nonzero | count_q[k];
  end
  assign accepted = known_q & (level_o ^ output_q);
`endif

  `ASSERT(CountingMeansACounterIsNotZero, counting_q == nonzero)
  `ASSERT(KnownForGood, (known_q & ~known_o) == '0)
  `ASSERT(AcceptsOnlyTheLevelThatTheInputHas, (accepted & (level_o ^ input_q)) == '0)
  `ASSERT(AcceptsOnlyAfterACount, (accepted & ~waiting_q) == '0)
  `ASSERT(AGlitchChangesNothing, (accepted & glitch_o) == '0)

  `COVER(LevelAcceptedRestarting, !mode_i && valid_i && (level_o ^ $past(level_o)) != '0)
  `COVER(LevelAcceptedUpDown, mode_i && valid_i && (level_o ^ $past(level_o)) != '0)
  `COVER(GlitchRestarting, !mode_i && glitch_o != '0)
  `COVER(GlitchUpDown, mode_i && glitch_o != '0)
  `COVER(CountGoesDown, down != '0)
  `COVER(LineBecomesKnown, known_o != $past(known_o))

endmodule
