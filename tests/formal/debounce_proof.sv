// debounce of one line in both modes, for every constant time.
`include "assert.svh"
`default_nettype none

module debounce_proof (
  input wire       clk_i,
  input wire       rst_ni,
  input wire       mode_i,
  input wire [7:0] time_i,
  input wire       valid_i,
  input wire [0:0] level_i
);

  logic [0:0] level_o, known_o, glitch_o;
  logic       idle_o;
  debounce #(.Lines(1)) u_dut (.*);

  `RESET_FIRST

  logic       after_q = 1'b0;
  logic       mode_q, valid_q, level_q, output_q, known_q;
  logic [7:0] time_q;
  always_ff @(posedge clk_i) begin
    after_q  <= rst_ni;
    mode_q   <= mode_i;
    time_q   <= time_i;
    valid_q  <= rst_ni && valid_i;
    level_q  <= level_i;
    output_q <= level_o;
    known_q  <= rst_ni && known_o;
  end
  `ASSUME(SettingsAreLeftAlone, !after_q || (time_i == time_q && mode_i == mode_q))
  `ASSUME(ValidForGood, !valid_q || valid_i)

  logic [8:0] needed;  // samples; a time of 0 acts as 1
  assign needed = (time_i == 8'd0) ? 9'd1 : {1'b0, time_i};

  // Up to the previous clock the input had level_q for stable_q valid samples in a row. against_q of the samples since
  // the output changed or became known were different from it. Both counters saturate.
  logic [8:0] stable_q, against_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || !valid_i) stable_q <= '0;
    else if (stable_q == '0 || level_i != level_q) stable_q <= 9'd1;
    else if (stable_q != '1) stable_q <= stable_q + 9'd1;

    if (!rst_ni || !known_o) against_q <= '0;
    else if (known_q && level_o != output_q) against_q <= {8'd0, level_i != level_o};
    else if (against_q != '1) against_q <= against_q + {8'd0, level_i != level_o};
  end

  // The count of the filter: `flatten` connects these nets to its wires of the same names.
  (* hierconn *) wire \u_dut.count_q[0] , \u_dut.count_q[1] , \u_dut.count_q[2] , \u_dut.count_q[3] ;
  (* hierconn *) wire \u_dut.count_q[4] , \u_dut.count_q[5] , \u_dut.count_q[6] , \u_dut.count_q[7] ;
  logic [7:0] own_count;
  assign own_count = {\u_dut.count_q[7] , \u_dut.count_q[6] , \u_dut.count_q[5] , \u_dut.count_q[4] ,
                      \u_dut.count_q[3] , \u_dut.count_q[2] , \u_dut.count_q[1] , \u_dut.count_q[0] };

  // The count as specified in the header of debounce.sv.
  logic       counts, done, done_q;
  logic [7:0] count_q;
  assign counts = (level_i != level_o) == known_o;
  assign done   = counts && {1'b0, count_q} + 9'd1 >= needed;
  always_ff @(posedge clk_i) begin
    done_q <= rst_ni && valid_i && done;
    if (!rst_ni) count_q <= '0;
    else if (valid_i) begin
      if (counts && !done) count_q <= count_q + 8'd1;
      else if (!counts && mode_i && count_q != '0) count_q <= count_q - 8'd1;
      else count_q <= '0;
    end
  end

  logic changes, becomes_known;
  assign changes       = known_q && level_o != output_q;
  assign becomes_known = after_q && known_o && !known_q;

  `ASSERT(ChangesAtTheFullCount, !known_q || changes == done_q)
  `ASSERT(KnownAtTheFullCount, !(after_q && !known_q) || becomes_known == done_q)
  `ASSERT(StaysKnown, !(after_q && known_q) || known_o)
  `ASSERT(ChangesToTheInput, !changes || level_o == level_q)
  `ASSERT(ChangesAfterAsManySamples, !changes || against_q >= needed)
  `ASSERT(ChangesAfterAStableInput, !(changes && !mode_i) || stable_q >= needed)
  `ASSERT(KnownAfterAStableInput, !(becomes_known && !mode_i) || (level_o == level_q && stable_q >= needed))
  `ASSERT(FollowsAStableInput, !(known_q && stable_q >= needed) || level_o == level_q)
  `ASSERT(FollowsTheInputUntilItIsValid, !(after_q && !valid_q) || level_o == level_q)
  `ASSERT(KnowsAStableInput, !(after_q && !mode_i && stable_q > needed) || known_o)

  // A glitch: the count returns to 0 because the input agrees with the output again.
  logic drops, drops_q;
  assign drops = known_o && valid_i && count_q != '0 && !counts && (!mode_i || count_q == 8'd1);
  always_ff @(posedge clk_i) drops_q <= rst_ni && drops;
  `ASSERT(ReportsEachDroppedChangeOnce, glitch_o == drops_q)
  `ASSERT(DropsWhileValid, !drops_q || valid_q)

  // Invariants of the count. With them the assertions above are inductive.
  logic differs;
  assign differs = stable_q != '0 && level_q != level_o;
  `ASSERT(CountIsTheFilters, count_q == own_count)
  `ASSERT(SamplesSinceValid, (stable_q != '0) == valid_q && (after_q || !valid_q))
  `ASSERT(CountIsNotFull, {1'b0, count_q} < needed)
  `ASSERT(CountRestarts, !done_q || count_q == '0)
  `ASSERT(CountNeedsAValidInput, stable_q != '0 || (count_q == '0 && !known_o))
  `ASSERT(CountIsStable, !(known_o && differs) || (mode_i ? {1'b0, count_q} >= stable_q : {1'b0, count_q} == stable_q))
  `ASSERT(CountIsCleared, !(known_o && !differs && !mode_i) || count_q == '0)
  `ASSERT(CountIsOfSamplesAgainst, !known_o || changes || {1'b0, count_q} <= against_q)
  `ASSERT(CandidateIsTheInput, !(!known_o && stable_q != '0 && !mode_i) ||
          (level_o == level_q && {1'b0, count_q} <= stable_q && {1'b0, count_q} + 9'd1 >= stable_q))

  `REACH(StartsHigh, after_q && !valid_q && level_o)
  `REACH(Rises, changes && level_o && needed == 9'd5)
  `REACH(FallsInChatter, changes && !level_o && mode_i && needed == 9'd3 && stable_q == 9'd2)
  `REACH(Glitches, glitch_o)
  `REACH(GlitchesInChatter, glitch_o && mode_i && against_q == 9'd3)

endmodule

`default_nettype wire
