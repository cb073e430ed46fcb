// Debounce filter for `Lines` synchronised one-bit lines (Vo 2021, Figure 4): a new level is accepted when it has been
// stable for `time_i` cycles; every change back restarts the count.
//
// While a line agrees with its output nothing is counted, so an idle line switches no flop. The counters are stored by
// bit position: count_q[k] holds bit k of every counter, so eight vector steps count all lines at once.
//
// After reset a line is unknown: the output follows the input, nothing is reported, and the line becomes known when it
// has first been stable for `time_i` cycles. The level found there was never an edge.
`include "assert.svh"

module debounce #(
  parameter int Lines = 1
) (
  input  logic             clk_i,
  input  logic             rst_ni,    // synchronous
  input  logic [7:0]       time_i,    // cycles; 0 and 1 accept the first sample
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

  // Scratch of the clocked process, written before it is read.
  logic [CountBits-1:0] last;    // count of the last cycle that is needed
  logic [Lines-1:0]     done;    // this is that cycle
  logic [Lines-1:0]     carry;

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

      carry = counts & ~done;
      for (int k = 0; k < CountBits; k++) begin
        count_q[k] <= (count_q[k] ^ carry) & counts & ~done;
        carry = carry & count_q[k];
      end

      counting_q <= counts & ~done;
      level_o    <= level_o ^ (differs & (done | ~known_o));
      known_o    <= known_o | done;
      glitch_o   <= known_o & counting_q & ~differs;
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

endmodule
