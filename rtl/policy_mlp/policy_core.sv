// Core of policy_mlp: evaluates the network of an image that it reads row by row, one row in a clock. No bus port.
//
// A run reads the image once from its beginning, so its checksum is that of every weight that was used. Between two
// layers it waits until the last value of the first one has been written. No image, whatever it contains, takes more
// than 1 + rows of the memory + 4 * Pipeline clocks.
`include "assert.svh"
`include "policy_mlp_reg_types.svh"

module policy_core #(
  parameter int Lanes = 8  // weights in a row: 4, 8 or 16
) (
  input  logic               clk_i,
  input  logic               rst_ni,    // synchronous
  output logic               active_o,  // clock request; 0: an edge changes no flop unless a register has just changed

  /* verilator tracing_off */
  input  policy_mlp_reg2hw_t reg2hw_i,
  output policy_mlp_hw2reg_t hw2reg_o,
  /* verilator tracing_on */

  output logic               irq_o
);

  localparam int Rows     = 16384 / Lanes;
  localparam int RowBits  = $clog2(Rows);
  localparam int Pipeline = 5;            // clocks from a row to the value of its neuron
  localparam int ChunkBits = $clog2(64 / Lanes);

  typedef enum logic [2:0] {Idle, Fetch, Layer, Parameters, Weights, Drain} state_e;
  state_e               state_q;
  logic [RowBits:0]     next_row_q;       // to be read
  logic                 relu_q, last_layer_q, malformed_q, done_q, corrupt_q, refused_q, ended_q;
  logic [1:0]           layer_q;
  logic                 layers_q;         // a layer has begun
  logic [5:0]           neuron_q, neurons_q;  // of the layer; neurons_q: the last one
  logic [ChunkBits-1:0] chunk_q, chunks_q;    // row of the neuron; chunks_q: the last one
  logic [2:0]           drain_q;
  logic [12:0]          cycles_q;

  // The memory.
  logic                 start, refused, read, takes, stores, whole;
  logic                 in_layer, in_parameters, in_weights;
  logic [11:0]          address_q;
  logic [8*Lanes-1:0]   row;
  assign whole   = reg2hw_i.wstrb == '1;
  assign start   = reg2hw_i.ctrl_start && state_q == Idle;
  assign stores  = reg2hw_i.data_we && whole && state_q == Idle;
  assign refused = (reg2hw_i.ctrl_start || (reg2hw_i.data_we && whole)) && state_q != Idle;
  assign in_layer      = state_q == Layer;
  assign in_parameters = state_q == Parameters;
  assign in_weights    = state_q == Weights;
  assign takes   = in_layer || in_parameters || in_weights;
  assign read    = takes || state_q == Fetch;

  policy_memory #(.Lanes(Lanes)) u_memory (
    .clk_i, .write_i(stores), .waddr_i(address_q), .wdata_i(reg2hw_i.wdata), .read_i(read),
    .raddr_i(next_row_q[RowBits-1:0]), .rdata_o(row)
  );

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      address_q <= '0;
    end else begin
      if (stores) address_q <= address_q + 12'd1;
      if (reg2hw_i.address_we && reg2hw_i.wstrb[0]) address_q[7:0] <= reg2hw_i.wdata[7:0];
      if (reg2hw_i.address_we && reg2hw_i.wstrb[1]) address_q[11:8] <= reg2hw_i.wdata[11:8];
    end
  end

  logic [31:0] checksum;
  policy_crc #(.Lanes(Lanes)) u_crc (
    .clk_i, .rst_ni, .clear_i(start), .add_i(takes), .row_i(row), .crc_o(checksum)
  );

  // Parameters of a neuron: 64 bits, which take two rows of four lanes.
  logic [63:0] parameters;
  logic        parameters_end;
  if (Lanes == 4) begin : g_two_rows
    logic        second_q;
    logic [31:0] low_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) second_q <= 1'b0;
      else second_q <= in_parameters && !second_q;
    end
    always_ff @(posedge clk_i) begin
      if (in_parameters) low_q <= row;
    end
    assign parameters     = {row, low_q};
    assign parameters_end = second_q;
  end else begin : g_one_row
    assign parameters     = row[63:0];
    assign parameters_end = 1'b1;
  end
  logic             neuron_end, layer_end, written;
  logic [7:0]       value;
  logic [5:1]       filled;
  logic [8*Lanes-1:0] values;
  assign neuron_end = in_weights && chunk_q == chunks_q;
  assign layer_end  = neuron_end && neuron_q == neurons_q;

  policy_neuron #(.Lanes(Lanes)) u_neuron (
    .clk_i, .rst_ni, .set_i(in_parameters && parameters_end), .bias_i(parameters[23:0]),
    .shift_i(parameters[28:24]), .multiplier_i(parameters[47:32]), .row_i(in_weights),
    .index_i(4'(chunk_q)), .last_i(neuron_end), .weights_i(row), .values_i(values), .relu_i(relu_q),
    .filled_o(filled), .done_o(written), .value_o(value)
  );

  logic unused;
  assign unused = ^{filled, parameters[63:48], parameters[31:29], reg2hw_i.id_re, reg2hw_i.address_re,
                    reg2hw_i.data_re};

  logic [5:0] count;
  policy_values #(.Lanes(Lanes)) u_values (
    .clk_i, .rst_ni, .load_i(start), .inputs_i(reg2hw_i.input_values), .turn_i(in_layer),
    .first_i(!layers_q), .row_i(chunk_q), .row_o(values), .write_i(written), .value_i(value), .count_o(count)
  );

  // The end of a run.
  logic out_of_rows, ends, correct;
  assign out_of_rows = takes && next_row_q == (RowBits+1)'(Rows);
  assign ends        = state_q == Drain && drain_q == 3'(Pipeline - 1) &&
                       (last_layer_q || malformed_q || layer_q == 2'd3);
  assign correct     = last_layer_q && !malformed_q && checksum == reg2hw_i.crc_value;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q      <= Idle;
      next_row_q   <= '0;
      relu_q       <= 1'b0;
      last_layer_q <= 1'b0;
      malformed_q  <= 1'b0;
      done_q       <= 1'b0;
      corrupt_q    <= 1'b0;
      refused_q    <= 1'b0;
      ended_q      <= 1'b0;
      layer_q      <= '0;
      layers_q     <= 1'b0;
      neuron_q     <= '0;
      neurons_q    <= '0;
      chunk_q      <= '0;
      chunks_q     <= '0;
      drain_q      <= '0;
      cycles_q     <= '0;
    end else begin
      ended_q <= ends;
      if (refused) refused_q <= 1'b1;
      if (state_q != Idle) cycles_q <= cycles_q + 13'd1;
      if (read) next_row_q <= next_row_q + (RowBits+1)'(1);
      case (state_q)
        Idle: if (start) begin
          state_q      <= Fetch;
          next_row_q   <= '0;
          last_layer_q <= 1'b0;
          malformed_q  <= 1'b0;
          done_q       <= 1'b0;
          corrupt_q    <= 1'b0;
          refused_q    <= 1'b0;
          layer_q      <= '0;
          layers_q     <= 1'b0;
          drain_q      <= '0;
          cycles_q     <= '0;
        end
        Fetch: state_q <= Layer;
        Layer: begin
          state_q      <= Parameters;
          layers_q     <= 1'b1;
          neurons_q    <= row[5:0];
          chunks_q     <= row[8 +: ChunkBits];
          relu_q       <= row[16];
          last_layer_q <= row[17];
          neuron_q     <= '0;
          chunk_q      <= '0;
        end
        Parameters: if (parameters_end) state_q <= Weights;
        Weights: begin
          chunk_q <= chunk_q + ChunkBits'(1);
          if (neuron_end) begin
            state_q  <= layer_end ? Drain : Parameters;
            neuron_q <= neuron_q + 6'd1;
            chunk_q  <= '0;
          end
        end
        Drain: begin
          drain_q <= drain_q + 3'd1;
          if (drain_q == 3'(Pipeline - 1)) begin
            state_q <= ends ? Idle : Layer;
            layer_q <= layer_q + 2'd1;
            drain_q <= '0;
          end
        end
        default: state_q <= Idle;
      endcase
      if (out_of_rows && !(layer_end && last_layer_q)) begin
        state_q     <= Drain;
        malformed_q <= 1'b1;
      end
      if (ends) begin
        malformed_q <= malformed_q || !last_layer_q;
        corrupt_q   <= checksum != reg2hw_i.crc_value;
        done_q      <= correct;
      end
    end
  end

  // The first values of the last layer.
  logic [63:0] output_q;
  always_ff @(posedge clk_i) begin
    if (in_layer) output_q <= '0;
    else if (written && count[5:3] == '0) output_q[{count[2:0], 3'b000} +: 8] <= value;
  end

  // Their limit acts behind the flops: a write of BOUND changes what can be read at once.
  logic [6:0]  bound;
  logic [63:0] limited;
  assign bound = reg2hw_i.bound_value;
  for (genvar i = 0; i < 8; i++) begin : g_output
    logic signed [7:0] raw;
    assign raw = output_q[8*i +: 8];
    assign limited[8*i +: 8] = !done_q ? 8'd0 : raw > $signed({1'b0, bound}) ? {1'b0, bound} :
                               raw < -$signed({1'b0, bound}) ? -{1'b0, bound} : raw;
    `ASSERT(OutputIsBounded, $signed(limited[8*i +: 8]) <= $signed({1'b0, bound}) &&
                             $signed(limited[8*i +: 8]) >= -$signed({1'b0, bound}))
  end

  // One clock after the event, or what enables it.
  logic interrupt;
  assign interrupt = reg2hw_i.event_ended && reg2hw_i.ctrl_irq;

  // One flop, because a simulator reads it in every clock. What a write changes is used while the bus port of the block
  // still requests the clock for the response.
  logic awake_q;
  assign active_o = awake_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      irq_o   <= 1'b0;
      awake_q <= 1'b0;
    end else begin
      irq_o   <= interrupt;
      awake_q <= reg2hw_i.ctrl_start || state_q != Idle || ended_q || irq_o != interrupt;
    end
  end

  assign hw2reg_o.id_rdata         = {policy_mlp_reg_pkg::IdBlockReset, policy_mlp_reg_pkg::IdVersionReset, 8'(Lanes)};
  assign hw2reg_o.status_busy      = state_q != Idle;
  assign hw2reg_o.status_done      = done_q;
  assign hw2reg_o.status_refused   = refused_q;
  assign hw2reg_o.status_corrupt   = corrupt_q;
  assign hw2reg_o.status_malformed = state_q == Idle && malformed_q;
  assign hw2reg_o.event_ended_set  = ended_q;
  assign hw2reg_o.cycles_value     = cycles_q;
  assign hw2reg_o.crc_read_value   = state_q == Idle ? checksum : '0;
  assign hw2reg_o.address_rdata    = {20'd0, address_q};
  assign hw2reg_o.data_rdata       = '0;
  assign hw2reg_o.output_values    = limited;

  // A clock of a run reads a row or waits for the last value of a layer.
  `ASSERT(EachClockReadsOrDrains, state_q == Idle ||
                                  cycles_q == 13'(next_row_q) + 13'(Pipeline) * 13'(layer_q) + 13'(drain_q))
  `ASSERT(StateIsKnown, state_q <= Drain && (state_q != Fetch || next_row_q == '0))
  `ASSERT(ReadsNoMoreThanTheMemory, next_row_q <= (RowBits+1)'(Rows) ||
                                    (next_row_q == (RowBits+1)'(Rows + 1) && !read && (malformed_q || last_layer_q)))
  `ASSERT(DrainsOnlyInDrain, drain_q < 3'(Pipeline) && (state_q == Idle || state_q == Drain || drain_q == '0))
  `ASSERT(NeuronBeginsWithItsFirstRow, !in_parameters || chunk_q == '0)
  `ASSERT(EndsInTime, cycles_q <= 13'(1 + Rows + 4 * Pipeline))
  `ASSERT(LayerBeginsWithAnEmptyPipeline, !(state_q == Idle || state_q == Fetch || in_layer) || filled == '0)
  `ASSERT(PipelineDrains, state_q != Drain || (filled & ~(5'h1F << drain_q)) == '0)
  `COVER(FourLayers, ends && layer_q == 2'd3 && last_layer_q)
  `COVER(EndOfMemory, out_of_rows && layer_end && last_layer_q)

endmodule
