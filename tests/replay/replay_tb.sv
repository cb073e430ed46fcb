// Replays a vector file (vectors.hpp) on arm_soc in a four-state simulator, from power-up with every flop X. After
// every clock each output must be 0 or 1 and equal to the recorded one.
//
//   vvp replay +vectors=FILE    prints the first differences, one per line; last line: `N clocks, M differences`
module replay_tb;

  parameter PaperFabric = 0;
  localparam Reported = 50;

  reg clk, rst_n;

  // four_state.py generates Bits and Idle of a line, the line itself in `vector`, the instance of arm_soc with inputs
  // from the line, and the task check_outputs.
`include "replay_dut.svh"

  reg [8*1024-1:0] path;
  integer file, clocks, differences, i;

  // Prints one line if an output differs from the recording. X and Z always differ.
  task check(input [8*32-1:0] name, input [31:0] is, input [31:0] recorded);
    if (is !== recorded) begin
      differences = differences + 1;
      if (differences <= Reported) $display("clock %0d: %0s is %h, recorded %h", clocks, name, is, recorded);
    end
  endtask

  task edge_of_clock;
    begin
      #1 clk = 1'b1;
      #1 clk = 1'b0;
    end
  endtask

  initial begin
    clocks = 0;
    differences = 0;
    if (!$value$plusargs("vectors=%s", path)) path = "";
    file = $fopen(path, "r");
    if (file == 0) begin
      $display("cannot open the vectors");
      $finish;
    end
    clk = 1'b0;
    rst_n = 1'b0;
    vector = Idle;
    for (i = 0; i < 16; i = i + 1) edge_of_clock;
    rst_n = 1'b1;
    while ($fscanf(file, "%h", vector) == 1) begin
      edge_of_clock;
      clocks = clocks + 1;
      check_outputs;
    end
    $display("%0d clocks, %0d differences", clocks, differences);
    $finish;
  end

endmodule
