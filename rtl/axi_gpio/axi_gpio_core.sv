// Core of axi_gpio: two channels and the interrupt. It has no bus port.
//
// A pin change appears in gpio_i after two clock edges, in the interrupt status after three and in irq_o after four.
// An interrupt handler therefore reads the new level. The levels found after reset do not count as a change.
`include "assert.svh"
`include "axi_gpio_reg_types.svh"

module axi_gpio_core #(
  parameter bit          AllInputs    = 1'b0,  // see gpio_channel; those with a 2 are of channel 2
  parameter bit          AllOutputs   = 1'b0,
  parameter logic [15:0] DoutDefault  = 16'h0000,
  parameter logic [15:0] TriDefault   = 16'hFFFF,
  parameter bit          AllInputs2   = 1'b0,
  parameter bit          AllOutputs2  = 1'b0,
  parameter logic [15:0] DoutDefault2 = 16'h0000,
  parameter logic [15:0] TriDefault2  = 16'hFFFF
) (
  input  logic        clk_i,
  input  logic        rst_ni,         // synchronous

  // Pins. Inputs are synchronised, outputs are flops.
  input  logic [15:0] gpio_i,
  output logic [15:0] gpio_o,
  output logic [15:0] gpio_t_o,
  output logic [15:0] gpio_driven_o,  // gpio_o where gpio_t_o is 0, else 0, one clock later
  input  logic [15:0] gpio2_i,
  output logic [15:0] gpio2_o,
  output logic [15:0] gpio2_t_o,
  output logic        irq_o,          // level, active high
  output logic        awake_o,        // clock request; 0: the next edge changes no flop, unless it writes a register

  /* verilator tracing_off */
  input  axi_gpio_reg2hw_t reg2hw_i,
  output axi_gpio_hw2reg_t hw2reg_o
  /* verilator tracing_on */
);

  // Bit 0 is channel 1, bit 1 is channel 2.
  logic [1:0]  ier, toggle, isr_q;  // toggle: high for one cycle, inverts the status bit
  logic        data_we, tri_we, data2_we, tri2_we, enable, unused;
  logic [15:0] wdata, data, data2;
  logic [1:0]  wstrb;
  assign ier                  = {reg2hw_i.ier_channel2, reg2hw_i.ier_channel1};
  assign toggle               = (reg2hw_i.isr_we && reg2hw_i.wstrb[0]) ? reg2hw_i.wdata[1:0] : 2'b00;
  assign enable               = reg2hw_i.gier_enable;
  assign data_we              = reg2hw_i.data_we;
  assign tri_we               = reg2hw_i.tri_we;
  assign data2_we             = reg2hw_i.data2_we;
  assign tri2_we              = reg2hw_i.tri2_we;
  assign wdata                = reg2hw_i.wdata[15:0];
  assign wstrb                = reg2hw_i.wstrb[1:0];
  assign unused               = ^{reg2hw_i.data_re, reg2hw_i.tri_re, reg2hw_i.data2_re, reg2hw_i.tri2_re,
                                  reg2hw_i.isr_re, reg2hw_i.wdata[31:16], reg2hw_i.wstrb[3:2]};
  assign hw2reg_o.data_rdata  = {16'b0, data};
  assign hw2reg_o.tri_rdata   = {16'b0, gpio_t_o};
  assign hw2reg_o.data2_rdata = {16'b0, data2};
  assign hw2reg_o.tri2_rdata  = {16'b0, gpio2_t_o};
  assign hw2reg_o.isr_rdata   = {30'b0, isr_q};

  logic [31:0] pins, last_q;  // levels of channel 2 and channel 1, now and in the previous clock
  logic [2:0]  filled_q;      // samples taken after reset have reached the first flop, pins and last_q
  logic        differs;
  assign pins    = {gpio2_i, gpio_i};
  assign differs = pins != last_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      last_q   <= '0;
      filled_q <= '0;
    end else if (filled_q != '1 || differs) begin
      last_q   <= pins;
      filled_q <= {filled_q[1:0], 1'b1};
    end
  end

  logic [31:0] moved;
  logic [1:0]  changed;
  always_comb begin
    moved = '0;
    if (differs && filled_q == '1) moved = pins ^ last_q;
  end

  gpio_channel #(
    .AllInputs(AllInputs), .AllOutputs(AllOutputs), .DoutDefault(DoutDefault), .TriDefault(TriDefault)
  ) u_channel1 (
    .clk_i, .rst_ni, .data_we_i(data_we), .tri_we_i(tri_we), .wdata_i(wdata), .wstrb_i(wstrb),
    .data_o(data), .pins_i(gpio_i), .moved_i(moved[15:0]), .gpio_o, .gpio_t_o, .changed_o(changed[0])
  );

  gpio_channel #(
    .AllInputs(AllInputs2), .AllOutputs(AllOutputs2), .DoutDefault(DoutDefault2), .TriDefault(TriDefault2)
  ) u_channel2 (
    .clk_i, .rst_ni, .data_we_i(data2_we), .tri_we_i(tri2_we), .wdata_i(wdata), .wstrb_i(wstrb),
    .data_o(data2), .pins_i(gpio2_i), .moved_i(moved[31:16]), .gpio_o(gpio2_o), .gpio_t_o(gpio2_t_o),
    .changed_o(changed[1])
  );

  // irq_o follows a change two edges later.
  logic activity_q;
  always_ff @(posedge clk_i) activity_q <= !rst_ni || filled_q != '1 || changed != '0;
  assign awake_o = activity_q || filled_q != '1 || differs;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) isr_q <= '0;
    else if (changed != '0 || toggle != '0) isr_q <= (isr_q ^ toggle) | changed;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      gpio_driven_o <= '0;
      irq_o         <= 1'b0;
    end else begin
      gpio_driven_o <= gpio_o & ~gpio_t_o;
      irq_o         <= enable && (isr_q & ier) != '0;
    end
  end

  `COVER(ChangeOfChannel1InTheClockOfTheToggle, changed[0] && toggle[0])
  `COVER(ChangeOfChannel2InTheClockOfTheToggle, changed[1] && toggle[1])
  `COVER(BothChannelsChange, changed == 2'b11)
  `COVER(InterruptOfChannel1, irq_o && isr_q[0] && ier[0])
  `COVER(InterruptOfChannel2, irq_o && isr_q[1] && ier[1])
  `COVER(InterruptDisabled, (isr_q & ier) != '0 && !enable)

endmodule
