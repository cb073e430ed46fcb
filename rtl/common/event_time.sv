// Times of the first events of `Events` sticky flags: time_o[i] holds the time of the first event since flag i was last
// clear. An event in the very cycle in which software clears the flag keeps flag and time.
module event_time #(
  parameter int Events = 1
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,   // synchronous
  input  logic [31:0]          now_i,    // cycles
  input  logic [Events-1:0]    event_i,  // one cycle; sets the flag with the next clock edge
  input  logic [Events-1:0]    flag_i,   // the flag as it is in this cycle
  output logic [Events*32-1:0] time_o    // [i*32 +: 32], valid while flag i is set
);

  logic [Events-1:0] first;
  assign first = event_i & ~flag_i;

  for (genvar i = 0; i < Events; i++) begin : gen_event
    logic [31:0] time_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) time_q <= '0;
      else if (first[i]) time_q <= now_i;
    end
    assign time_o[i*32 +: 32] = time_q;
  end

endmodule
