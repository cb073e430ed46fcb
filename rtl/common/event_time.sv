// Times of the first events of `Events` sticky flags. time_o[i] is the time of the first event since flag i was last
// clear. If software clears the flag in the cycle of an event, the flag stays set and the time is kept.
`include "assert.svh"

module event_time #(
  parameter int Events = 1
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,   // synchronous
  input  logic [31:0]          now_i,    // cycles
  input  logic [Events-1:0]    event_i,  // one cycle; the next clock edge sets the flag
  input  logic [Events-1:0]    flag_i,   // present value of the flags
  output logic [Events*32-1:0] time_o    // [i*32 +: 32], valid while flag i is set
);

  // Temporaries of the clocked process, written before they are read.
  logic [Events-1:0]    first;
  logic [Events*32-1:0] stamped;

  /* verilator lint_off BLKSEQ */
  always_ff @(posedge clk_i) begin
    first = event_i & ~flag_i;
    if (!rst_ni) begin
      time_o <= '0;
    end else if (first != '0) begin
      stamped = time_o;
      for (int i = 0; i < Events; i++) if (first[i]) stamped[i*32 +: 32] = now_i;
      time_o <= stamped;
    end
  end
  /* verilator lint_on BLKSEQ */

`ifdef ASSERT_ON
  logic                 ran_q;  // the previous cycle was outside reset
  logic [Events*32-1:0] time_before_q;
  logic [Events-1:0]    event_before_q, flag_before_q;
  logic [31:0]          now_before_q;

  always_ff @(posedge clk_i) begin
    ran_q          <= rst_ni;
    time_before_q  <= time_o;
    event_before_q <= event_i;
    flag_before_q  <= flag_i;
    now_before_q   <= now_i;
  end

  for (genvar i = 0; i < Events; i++) begin : gen_assert
    `ASSERT(TimeOfASetFlagStands,
            !(ran_q && flag_before_q[i]) || time_o[i*32 +: 32] == time_before_q[i*32 +: 32])
    `ASSERT(TimeIsThatOfTheEvent,
            !(ran_q && event_before_q[i] && !flag_before_q[i]) || time_o[i*32 +: 32] == now_before_q)
  end
`endif

  `COVER(EventWhileItsFlagStands, (event_i & flag_i) != '0)

endmodule
