// One channel of axi_gpio: data and direction of 16 pins, and the detection of changes of its inputs. No bus port.
//
// A pin with TRI = 1 is an input: DATA reads its level, and a change of the level is an event. A pin with TRI = 0 is
// an output: DATA reads the written value, and the pin causes no event. A change of TRI is no event. The level of a
// pad may change because its pin is released, and this is an event.
`include "assert.svh"

module gpio_channel #(
  // As the vendor's C_ALL_INPUTS, C_ALL_OUTPUTS, C_DOUT_DEFAULT and C_TRI_DEFAULT. A channel of a fixed direction has
  // no TRI register: writes to TRI have no effect.
  parameter bit          AllInputs   = 1'b0,
  parameter bit          AllOutputs  = 1'b0,
  parameter logic [15:0] DoutDefault = 16'h0000,
  parameter logic [15:0] TriDefault  = 16'hFFFF
) (
  input  logic        clk_i,
  input  logic        rst_ni,      // synchronous

  // Registers. A write changes the bytes whose strobe is 1.
  input  logic        data_we_i,
  input  logic        tri_we_i,
  input  logic [15:0] wdata_i,
  input  logic [1:0]  wstrb_i,
  output logic [15:0] data_o,      // what DATA reads

  // Pins.
  input  logic [15:0] pins_i,      // synchronised levels
  input  logic [15:0] moved_i,     // pins_i that have another level than in the previous clock
  output logic [15:0] gpio_o,      // written value, from flops
  output logic [15:0] gpio_t_o,    // TRI, from flops

  output logic        changed_o    // an input has changed
);

  logic [15:0] released;  // TRI
  assign gpio_t_o = released;
  assign data_o   = (pins_i & released) | (gpio_o & ~released);

  if (AllInputs || AllOutputs) begin : g_fixed
    logic unused;
    assign released = {16{AllInputs}};
    assign unused   = tri_we_i;
  end else begin : g_direction
    logic [15:0] tri_q;
    assign released = tri_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) tri_q <= TriDefault;
      else if (tri_we_i) begin
        if (wstrb_i[0]) tri_q[7:0]  <= wdata_i[7:0];
        if (wstrb_i[1]) tri_q[15:8] <= wdata_i[15:8];
      end
    end
  end

  if (AllInputs) begin : g_no_data
    logic unused;
    assign gpio_o = '0;
    assign unused = ^{clk_i, rst_ni, data_we_i, wdata_i, wstrb_i};
  end else begin : g_data
    always_ff @(posedge clk_i) begin
      if (!rst_ni) gpio_o <= DoutDefault;
      else if (data_we_i) begin
        if (wstrb_i[0]) gpio_o[7:0]  <= wdata_i[7:0];
        if (wstrb_i[1]) gpio_o[15:8] <= wdata_i[15:8];
      end
    end
  end

  assign changed_o = (moved_i & released) != '0;

  `ASSERT(OneDirectionAtMost, !(AllInputs && AllOutputs))

  `COVER(InputChanges, changed_o)
  `COVER(OutputChangesWithoutAnEvent, moved_i != '0 && !changed_o)

endmodule
