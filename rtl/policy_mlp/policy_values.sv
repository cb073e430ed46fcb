// The values of the layers: what the layer before gave is read row by row, while the present one writes.
//
// A row that the layer before has not begun reads 0, and so does the rest of its last row.
module policy_values #(
  parameter int Lanes = 8  // bytes of a row
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,   // synchronous

  input  logic                           load_i,   // copies the inputs of the network, which are read next
  input  logic [255:0]                   inputs_i,
  input  logic                           turn_i,   // a layer begins: what was written can be read
  input  logic                           first_i,  // with turn_i: the first layer, which reads the inputs

  input  logic [$clog2(64/Lanes)-1:0]    row_i,
  output logic [8*Lanes-1:0]             row_o,

  input  logic                           write_i,  // the next value of the layer
  input  logic [7:0]                     value_i,
  output logic [5:0]                     count_o   // values that the layer has written
);

  localparam int Rows      = 64 / Lanes;
  localparam int InputRows = 32 / Lanes;
  localparam int RowBits   = $clog2(Rows);
  localparam int LaneBits  = $clog2(Lanes);

  logic [255:0]         inputs_q;
  logic [8*Lanes-1:0]   memory [2*Rows];
  logic [8*Lanes-1:0]   begun_q, written;  // the row that is being written
  logic                 bank_q, from_inputs_q;
  logic [5:0]           count_q;
  logic [RowBits:0]     rows_q;            // that can be read
  logic [RowBits:0]     write_row, read_row;
  logic [LaneBits-1:0]  lane;
  assign count_o   = count_q;
  assign lane      = count_q[LaneBits-1:0];
  assign write_row = {bank_q, count_q[5:LaneBits]};
  assign read_row  = {!bank_q, row_i};

  logic [8*Lanes-1:0] input_row, memory_row;
  assign input_row  = inputs_q[{row_i[RowBits-2:0], {(LaneBits+3){1'b0}}} +: 8*Lanes];
  assign memory_row = memory[read_row];
  assign row_o      = {1'b0, row_i} >= rows_q ? '0 : from_inputs_q ? input_row : memory_row;

  always_comb begin
    written = lane == '0 ? '0 : begun_q;
    written[{lane, 3'b000} +: 8] = value_i;
  end

  always_ff @(posedge clk_i) begin
    if (write_i) memory[write_row] <= written;
    if (write_i) begun_q <= written;
    if (load_i) inputs_q <= inputs_i;
  end

  // Rows that the values of the layer fill, the last one perhaps in part. 64 values are counted as 0.
  logic [6:0] full;
  assign full = count_q == '0 ? 7'd64 : {1'b0, count_q};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      bank_q        <= 1'b0;
      from_inputs_q <= 1'b0;
      count_q       <= '0;
      rows_q        <= '0;
    end else if (turn_i) begin
      bank_q        <= !bank_q;
      from_inputs_q <= first_i;
      count_q       <= '0;
      rows_q        <= first_i ? (RowBits+1)'(InputRows) : (RowBits+1)'((full + 7'(Lanes - 1)) >> LaneBits);
    end else if (write_i) begin
      count_q <= count_q + 6'd1;
    end
  end

endmodule
