// Memory of 16 KiB for the image of a network: block RAM with a port of 32 bits that writes and one of a row
// that reads.
module policy_memory #(
  parameter int Lanes = 8  // bytes of a row: 4, 8 or 16
) (
  input  logic                             clk_i,

  input  logic                             write_i,
  input  logic [11:0]                      waddr_i,  // word of 32 bits
  input  logic [31:0]                      wdata_i,

  input  logic                             read_i,
  input  logic [$clog2(16384/Lanes)-1:0]   raddr_i,  // row
  output logic [8*Lanes-1:0]               rdata_o   // the row of the last read, one clock later; holds until the next
);

  localparam int Banks = Lanes / 4;
  localparam int Rows  = 16384 / Lanes;

  for (genvar i = 0; i < Banks; i++) begin : g_bank
    logic [31:0] memory [Rows];
    logic        mine;
    // 0 from the configuration of the chip on. A reset does not change it.
    initial for (int row = 0; row < Rows; row++) memory[row] = '0;

    logic [$clog2(Rows)-1:0] row;
    if (Banks == 1) begin : g_one
      assign mine = write_i;
      assign row  = waddr_i;
    end else begin : g_many
      assign mine = write_i && waddr_i[$clog2(Banks)-1:0] == $clog2(Banks)'(i);
      assign row  = waddr_i[11:$clog2(Banks)];
    end
    always_ff @(posedge clk_i) begin
      if (mine) memory[row] <= wdata_i;
    end
    always_ff @(posedge clk_i) begin
      if (read_i) rdata_o[32*i +: 32] <= memory[raddr_i];
    end
  end

endmodule
