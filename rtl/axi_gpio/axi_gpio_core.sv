// Core of axi_gpio: outputs, inputs with change detection, and the interrupt. It has no bus port.
//
// A pin change appears in gpio_i after two clock edges, in the interrupt status after three and in irq_o after four.
// An interrupt handler therefore reads the new level. The levels found after reset do not count as a change.
`include "assert.svh"
`include "axi_gpio_reg_types.svh"

module axi_gpio_core (
  input  logic        clk_i,
  input  logic        rst_ni,   // synchronous

  // Pins.
  input  logic [15:0] gpio_i,   // synchronised
  output logic [15:0] gpio_o,   // pin levels, 0 after reset
  output logic        irq_o,    // level, active high
  output logic        awake_o,  // clock request; 0: the next edge changes no flop, unless it writes a register

  /* verilator tracing_off */
  input  axi_gpio_reg2hw_t reg2hw_i,
  output axi_gpio_hw2reg_t hw2reg_o
  /* verilator tracing_on */
);

  // Bit 0 is channel 1, bit 1 is channel 2.
  logic [1:0]  ier, toggle, isr_q;  // toggle: high for one cycle, inverts the status bit
  logic [15:0] data, released;
  logic        enable, unused;
  assign ier                  = {reg2hw_i.ier_channel2, reg2hw_i.ier_channel1};
  assign toggle               = (reg2hw_i.isr_we && reg2hw_i.wstrb[0]) ? reg2hw_i.wdata[1:0] : 2'b00;
  assign data                 = reg2hw_i.data_value;
  assign released             = reg2hw_i.tri_value;
  assign enable               = reg2hw_i.gier_enable;
  assign unused               = ^{reg2hw_i.isr_re, reg2hw_i.wdata[31:2], reg2hw_i.wstrb[3:1]};
  assign hw2reg_o.data2_value = gpio_i;
  assign hw2reg_o.isr_rdata   = {30'b0, isr_q};

  logic [15:0] last_q;    // inputs in the previous cycle
  logic [2:0]       filled_q;  // samples taken after reset have reached the first flop, gpio_i and last_q
  logic             changed;
  assign changed = filled_q[2] && gpio_i != last_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      last_q   <= '0;
      filled_q <= '0;
    end else if (filled_q != '1 || gpio_i != last_q) begin
      last_q   <= gpio_i;
      filled_q <= {filled_q[1:0], 1'b1};
    end
  end

  // irq_o follows a change two edges later.
  logic activity_q;
  always_ff @(posedge clk_i) activity_q <= !rst_ni || filled_q != '1 || changed;
  assign awake_o = activity_q || filled_q != '1 || changed;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) isr_q <= '0;
    else if (changed || toggle != '0) isr_q <= (isr_q ^ toggle) | {changed, 1'b0};
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      gpio_o <= '0;
      irq_o  <= 1'b0;
    end else begin
      gpio_o <= data & ~released;
      irq_o  <= enable && (isr_q & ier) != '0;
    end
  end

  `COVER(InputChanges, changed)
  `COVER(ChangeInTheClockOfTheToggle, changed && toggle[1])
  `COVER(InterruptOfChannel1, irq_o && isr_q[0] && ier[0])
  `COVER(InterruptOfChannel2, irq_o && isr_q[1] && ier[1])
  `COVER(InterruptDisabled, (isr_q & ier) != '0 && !enable)

endmodule
