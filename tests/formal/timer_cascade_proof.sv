// timer_core in cascade: {TCR1, TCR0} is one counter of 64 bits, with a period of its load value + 4 down, and of the
// distance of the load value to 2^64 - 1, + 4, up. The pulse, the flag and the interrupt are those of timer 0.
//
// Single clocks prove a statement about up to 2^64 clocks: `rest_q` is set to the load value three clocks after a
// pulse, each clock decrements it, and the next pulse must come exactly when `rest_q` has reached its end.
`include "assert.svh"
`default_nettype none

module timer_cascade_proof (
`include "timer_core_inputs.svh"
);

`include "timer_core_outputs.svh"
  timer_core_flat u_dut (.*, .clk_gated_i(clk_i));

  `RESET_FIRST

  // Generate mode with GENT, ARHT and CASC in TCSR0; no LOAD in either register; any other bits.
  (* hierconn *) wire \u_dut.u_flat.freeze ;
  logic [63:0] count, value, distance;
  logic        down, cascade, runs, loads;
  assign count    = {tcr1_rdata_o, tcr0_rdata_o};
  assign value    = {tlr1_rdata_o, tlr0_rdata_o};
  assign down     = tcsr0_rdata_o[1];
  assign distance = down ? value : ~value;  // clocks from the load value to the end of the range
  assign loads    = tcsr0_rdata_o[11] && tcsr0_rdata_o[5] && tcsr1_rdata_o[5];
  assign cascade  = tcsr0_rdata_o[11] && {tcsr0_rdata_o[5:4], tcsr0_rdata_o[2], tcsr0_rdata_o[0]} == 4'b0110 &&
                    !tcsr1_rdata_o[5];
  assign runs     = tcsr0_rdata_o[7] && !\u_dut.u_flat.freeze ;

  // A period is steady from a pulse, or from a load of both halves, as long as mode, direction and load value stay.
  // wait_q: clocks that still show the wrapped value; 0: it counts, and ends after rest_q + 1 clocks.
  logic        cascade_q, loads_q, steady_q, down_q, ran_q, enit_q, pulse_q, steady;
  logic [63:0] value_q, rest_q, rest;
  logic [1:0]  wait_q, shown;
  logic        begins, ends_q;
  assign begins = cascade_q && generate_o[0];
  assign steady = cascade && value == value_q && down == down_q && (begins || loads_q || steady_q);
  assign shown  = begins ? 2'd3 : loads_q ? 2'd0 : wait_q;
  assign rest   = loads_q ? distance : rest_q;

  always_ff @(posedge clk_i) begin
    cascade_q <= rst_ni && cascade;
    loads_q   <= rst_ni && loads;
    value_q   <= value;
    down_q    <= down;
    ran_q     <= runs;
    pulse_q   <= rst_ni && generate_o[0];
    enit_q    <= tcsr0_rdata_o[6];
    steady_q  <= rst_ni && steady;
    ends_q    <= runs && shown == '0 && rest == '0;  // this clock edge ends the period
    if (runs && shown != '0) wait_q <= shown - 2'd1;
    else wait_q <= shown;
    if (runs) rest_q <= shown == 2'd1 ? distance : rest - 64'd1;
    else rest_q <= rest;
  end

  `ASSERT(PulsesExactlyAtTheEndOfAPeriod, !steady_q || generate_o[0] == ends_q)
  `ASSERT(CountsAsOneNumber, !steady || count == (shown != '0 ? (down ? '1 : '0) : (down ? rest : ~rest)))
  `ASSERT(SetsTheFlagWithThePulse, !begins || tcsr0_rdata_o[8])
  `ASSERT(InterruptsAClockLater, !(pulse_q && enit_q) || irq_o)
  `ASSERT(Timer1HasNoPulse, !cascade_q || !generate_o[1])

  (* hierconn *) wire [1:0] \u_dut.u_flat.u_timer0.u_counter.left_q , \u_dut.u_flat.u_timer1.u_counter.left_q ;
  `ASSERT(ShowsTheWrappedValueForThreeClocks,
          (!steady || \u_dut.u_flat.u_timer0.u_counter.left_q == shown) &&
          (!generate_o[0] || \u_dut.u_flat.u_timer0.u_counter.left_q != '0) &&
          (!generate_o[1] || \u_dut.u_flat.u_timer1.u_counter.left_q != '0))

  `REACH(ShortestPeriodDown, steady_q && generate_o[0] && down_q && value_q == '0 && wait_q == '0)
  `REACH(ShortestPeriodUp, steady_q && generate_o[0] && !down_q && value_q == '1 && wait_q == '0)
  `REACH(CarriesBetweenTwoEnds, steady && runs && count == 64'h1_0000_0000 && down)
  `REACH(StartsFromALoad, loads_q && steady && runs)

endmodule

`default_nettype wire
