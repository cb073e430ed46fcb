// Outputs, inputs with change detection, and the interrupt of axi_gpio. It never sees the bus; ports are named as the
// registers they serve.
//
// A pin change shows in gpio_i after two clock edges, in the interrupt status after three and in irq_o after four: who
// sees the interrupt reads the new level. The levels found after reset are no change.
`include "assert.svh"

module axi_gpio_core #(
  parameter int Width = 16
) (
  input  logic             clk_i,
  input  logic             rst_ni,     // synchronous

  // Pins.
  input  logic [Width-1:0] gpio_i,     // synchronised
  output logic [Width-1:0] gpio_o,
  output logic             irq_o,      // level
  output logic             awake_o,    // 0: no flop would change at the next edge, unless a register is written

  input  logic [Width-1:0] data_i,     // level of the outputs
  input  logic [Width-1:0] tri_i,      // 1: the output is low
  input  logic             enable_i,   // global
  input  logic [1:0]       ier_i,      // bit 0 channel 1, bit 1 channel 2
  input  logic [1:0]       toggle_i,   // one cycle: inverts the status bit
  output logic [1:0]       isr_o
);

  logic [Width-1:0] last_q;    // inputs of the cycle before
  logic [2:0]       filled_q;  // samples taken after reset have reached first flop, gpio_i, last_q
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

  // irq_o follows a change by two edges.
  logic stirred_q;
  always_ff @(posedge clk_i) stirred_q <= !rst_ni || filled_q != '1 || changed;
  assign awake_o = stirred_q || filled_q != '1 || changed;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) isr_o <= '0;
    else if (changed || toggle_i != '0) isr_o <= (isr_o ^ toggle_i) | {changed, 1'b0};
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      gpio_o <= '0;
      irq_o  <= 1'b0;
    end else begin
      gpio_o <= data_i & ~tri_i;
      irq_o  <= enable_i && (isr_o & ier_i) != '0;
    end
  end

  `COVER(InputChanges, changed)
  `COVER(ChangeInTheClockOfTheToggle, changed && toggle_i[1])
  `COVER(InterruptOfChannel1, irq_o && isr_o[0] && ier_i[0])
  `COVER(InterruptOfChannel2, irq_o && isr_o[1] && ier_i[1])
  `COVER(InterruptDisabled, (isr_o & ier_i) != '0 && !enable_i)

endmodule
