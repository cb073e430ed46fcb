// gpio_channel: data, direction and events of each bit, for any writes and any levels of the pins.
`include "assert.svh"
`default_nettype none

module gpio_channel_proof (
  input wire        clk_i,
  input wire        rst_ni,
  input wire        data_we_i,
  input wire        tri_we_i,
  input wire [15:0] wdata_i,
  input wire [1:0]  wstrb_i,
  input wire [15:0] pins_i,
  input wire [15:0] moved_i
);

  localparam logic [15:0] Dout = 16'hA5C3, Tri = 16'h0FF0;

  logic [15:0] data_o, gpio_o, gpio_t_o;
  logic        changed_o;
  gpio_channel #(.DoutDefault(Dout), .TriDefault(Tri)) u_dut (.*);

  `RESET_FIRST

  // The previous clock. after_q: it was outside reset.
  logic        after_q = 1'b0;
  logic        data_we_q, tri_we_q;
  logic [15:0] wdata_q, written_q, data_q, tri_q;
  always_ff @(posedge clk_i) begin
    after_q   <= rst_ni;
    data_we_q <= data_we_i;
    tri_we_q  <= tri_we_i;
    wdata_q   <= wdata_i;
    written_q <= {{8{wstrb_i[1]}}, {8{wstrb_i[0]}}};
    data_q    <= gpio_o;
    tri_q     <= gpio_t_o;
  end

  logic [15:0] event_bits;
  for (genvar i = 0; i < 16; i++) begin : gen_bit
    `ASSERT(DataReadsPinOrLatch, data_o[i] == (gpio_t_o[i] ? pins_i[i] : gpio_o[i]))
    `ASSERT(DataIsWrittenByteByByte,
            !after_q || gpio_o[i] == (data_we_q && written_q[i] ? wdata_q[i] : data_q[i]))
    `ASSERT(DirectionIsWrittenByteByByte,
            !after_q || gpio_t_o[i] == (tri_we_q && written_q[i] ? wdata_q[i] : tri_q[i]))
    assign event_bits[i] = gpio_t_o[i] && moved_i[i];
  end
  formal_rule DataResets (.live(running_q && !after_q), .holds(gpio_o == Dout));
  formal_rule DirectionResets (.live(running_q && !after_q), .holds(gpio_t_o == Tri));
  `ASSERT(AnEventIsAChangeOfAnInput, changed_o == (event_bits != '0))

  `REACH(AnInputChanges, changed_o)
  `REACH(AnOutputChangesAlone, moved_i != '0 && !changed_o)
  `REACH(ADirectionChangesWithoutAnEvent, after_q && gpio_t_o != tri_q && !changed_o)

endmodule

`default_nettype wire
