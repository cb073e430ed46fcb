// Debounce filter for `Lines` synchronised one-bit lines. Each line has a counter. The counter counts the samples that
// differ from the output, and the output changes when the count reaches `time_i`. mode_i selects the effect of a sample
// that agrees with the output:
//
//   restart (mode_i = 0)   It clears the count (Vo 2021, Figure 4). A level is accepted when it has been stable for
//                          `time_i` cycles. A line that bounces at least once in every `time_i` cycles is never
//                          accepted.
//   up/down (mode_i = 1)   It decrements the count. The counter saturates at 0 and at `time_i`, and the output changes
//                          at these ends. N samples against a new level delay it by 2 N cycles at most.
//
// Both modes pass clean levels of at least `time_i` cycles with the same delay, and suppress shorter ones between long
// stable phases.
//
// While a line agrees with its output and its count is 0, no flop of the line toggles. The counters are bit-sliced:
// count_q[k] holds bit k of every counter, so eight vector operations update all counters.
//
// After reset a line is unknown, and no change is reported. The output then holds the candidate for the level. A sample
// that agrees increments the count, and the line becomes known when the count reaches `time_i`; this level is not an
// edge. In restart mode a sample that differs clears the count and becomes the candidate. In up/down mode it decrements
// the count, and becomes the candidate if the count is 0.
`include "assert.svh"

module debounce #(
  parameter int Lines = 1
) (
  input  logic             clk_i,
  input  logic             rst_ni,    // synchronous
  input  logic             mode_i,    // 0 restart, 1 up/down; a change takes effect at once and keeps the counts
  input  logic [7:0]       time_i,    // cycles; 0 and 1 accept the first sample; a change takes effect at once
  input  logic             valid_i,   // level_i is valid; 0 while the synchroniser fills after reset
  input  logic [Lines-1:0] level_i,   // synchronised
  output logic [Lines-1:0] level_o,   // accepted level; follows a stable change of level_i after `time_i` cycles
  output logic [Lines-1:0] known_o,   // level_o is an accepted level
  output logic             idle_o,    // every line is known, and every count is 0
  output logic [Lines-1:0] glitch_o   // one cycle: a change of a known line was too short and was dropped
);

  localparam int CountBits = 8;  // as time_i

  logic [Lines-1:0] count_q [CountBits];
  logic [Lines-1:0] counting_q;  // lines whose counter is not 0

  assign idle_o = counting_q == '0 && known_o == '1;

  // Temporaries of the clocked process, written before they are read.
  logic [Lines-1:0]     differs;  // the sample differs from the output
  logic [Lines-1:0]     counts;   // a known line counts while it differs from its output, an unknown one while equal
  logic [Lines-1:0]     down;     // the sample decrements the count
  logic [CountBits-1:0] last;     // count in the last cycle before acceptance
  logic [Lines-1:0]     done;     // the count has reached `last`
  logic [Lines-1:0]     moves;    // the count changes by one, up or down; other counts are cleared
  logic [Lines-1:0]     carry;    // or borrow
  logic [Lines-1:0]     next, left;

  /* verilator lint_off BLKSEQ */
  always_ff @(posedge clk_i) begin
    differs = level_i ^ level_o;
    counts  = ~(differs ^ known_o);
    down    = counting_q & ~counts & {Lines{mode_i}};
    if (!rst_ni) begin
      level_o    <= '0;
      known_o    <= '0;
      glitch_o   <= '0;
      counting_q <= '0;
      for (int k = 0; k < CountBits; k++) count_q[k] <= '0;
    end else if (!valid_i) begin
      level_o <= level_i;
    end else if ((counts | counting_q) != '0 || known_o != '1) begin
      // count >= last, from the lowest bit upwards. This is also correct after `time_i` has been reduced.
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
  // Values before the previous clock edge.
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
