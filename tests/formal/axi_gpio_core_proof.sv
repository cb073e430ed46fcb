// axi_gpio_core behind its synchronisers: both channels, the interrupt status, its enables and the interrupt line.
//
// Two copies: one with two bidirectional channels, and one whose channel 2 has inputs only, as in arm_soc.
`include "assert.svh"
`default_nettype none

module axi_gpio_core_proof (
  input wire        clk_i,
  input wire        rst_ni,
  input wire [31:0] pins_i,  // levels of the pads of channel 2 and 1; they may be asynchronous
  input wire [31:0] wdata_i,
  input wire [3:0]  wstrb_i,
  input wire        data_we_i,
  input wire        tri_we_i,
  input wire        data2_we_i,
  input wire        tri2_we_i,
  input wire        isr_we_i,
  input wire        gier_enable_i,
  input wire [1:0]  ier_i
);

  `RESET_FIRST

  axi_gpio_core_check #(.Inputs2(1'b0)) u_both (.*);
  axi_gpio_core_check #(.Inputs2(1'b1)) u_fixed (.*);

endmodule

module axi_gpio_core_check #(
  parameter bit Inputs2 = 1'b0  // channel 2 has inputs only
) (
  input wire        clk_i,
  input wire        rst_ni,
  input wire [31:0] pins_i,
  input wire [31:0] wdata_i,
  input wire [3:0]  wstrb_i,
  input wire        data_we_i,
  input wire        tri_we_i,
  input wire        data2_we_i,
  input wire        tri2_we_i,
  input wire        isr_we_i,
  input wire        gier_enable_i,
  input wire [1:0]  ier_i
);

  localparam logic [31:0] Dout = 32'h3C5A_A5C3, Tri = 32'hF0F0_0FF0;

  logic [31:0] level;
  sync_2ff #(.Width(32)) u_sync (.clk_i, .rst_ni, .async_i(pins_i), .level_o(level));

  logic [15:0] gpio_o, gpio_t_o, gpio_driven_o, gpio2_o, gpio2_t_o;
  logic [31:0] data_rdata_o, tri_rdata_o, data2_rdata_o, tri2_rdata_o, isr_rdata_o;
  logic        irq_o, awake_o;
  axi_gpio_core_flat #(
    .DoutDefault(Dout[15:0]), .TriDefault(Tri[15:0]),
    .AllInputs2(Inputs2), .DoutDefault2(Dout[31:16]), .TriDefault2(Tri[31:16])
  ) u_dut (
    .*, .gpio_i(level[15:0]), .gpio2_i(level[31:16]), .ier_channel1_i(ier_i[0]), .ier_channel2_i(ier_i[1]),
    .data_re_i(1'b0), .tri_re_i(1'b0), .data2_re_i(1'b0), .tri2_re_i(1'b0), .isr_re_i(1'b0)
  );

  // The newest samples of the pins, and whether they have been taken outside reset.
  logic [31:0] sample1_q, sample2_q, sample3_q;
  logic        valid1_q, valid2_q, valid3_q;
  always_ff @(posedge clk_i) begin
    {sample3_q, sample2_q, sample1_q} <= rst_ni ? {sample2_q, sample1_q, pins_i} : '0;
    {valid3_q, valid2_q, valid1_q}    <= rst_ni ? {valid2_q, valid1_q, 1'b1} : '0;
  end

  // The registers of both channels.
  logic [31:0] data_q, tri_q, is_input, out;
  logic [1:0]  data_we, tri_we;
  assign data_we  = {data2_we_i, data_we_i};
  assign tri_we   = {tri2_we_i, tri_we_i};
  assign is_input = Inputs2 ? {16'hFFFF, tri_q[15:0]} : tri_q;
  assign out      = Inputs2 ? {16'h0000, data_q[15:0]} : data_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) {data_q, tri_q} <= {Dout, Tri};
    else begin
      for (int b = 0; b < 32; b++) begin
        if (data_we[b / 16] && wstrb_i[b % 16 / 8]) data_q[b] <= wdata_i[b % 16];
        if (tri_we[b / 16] && wstrb_i[b % 16 / 8]) tri_q[b] <= wdata_i[b % 16];
      end
    end
  end

  // A change is a difference between two samples of an input, both taken outside reset. It sets the status bit of its
  // channel, also in the clock of a write. A written 1 inverts the bit.
  logic [31:0] changed;
  logic [1:0]  changes, toggles, status_q;
  logic [15:0] driven_q;
  logic        irq_q;
  assign changed = valid3_q ? (sample2_q ^ sample3_q) & is_input : '0;
  assign changes = {changed[31:16] != '0, changed[15:0] != '0};
  assign toggles = isr_we_i && wstrb_i[0] ? wdata_i[1:0] : 2'b00;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) {status_q, irq_q, driven_q} <= '0;
    else begin
      for (int c = 0; c < 2; c++) begin
        if (changes[c]) status_q[c] <= 1'b1;
        else if (toggles[c]) status_q[c] <= !status_q[c];
      end
      irq_q    <= gier_enable_i && ((status_q[0] && ier_i[0]) || (status_q[1] && ier_i[1]));
      driven_q <= data_q[15:0] & ~tri_q[15:0];
    end
  end

  `ASSERT(DataReadsPinOrLatch, {data2_rdata_o[15:0], data_rdata_o[15:0]} ==
                               ((sample2_q & is_input) | (out & ~is_input)))
  `ASSERT(DirectionReadsBack, {tri2_rdata_o[15:0], tri_rdata_o[15:0]} == is_input)
  `ASSERT(UpperBitsReadZero, {data_rdata_o[31:16], tri_rdata_o[31:16], data2_rdata_o[31:16], tri2_rdata_o[31:16],
                              isr_rdata_o[31:2]} == '0)
  `ASSERT(PinsFollowTheRegisters, {gpio2_o, gpio_o} == out && {gpio2_t_o, gpio_t_o} == is_input)
  `ASSERT(DrivesOutputsOnly, gpio_driven_o == driven_q)
  `ASSERT(StatusIsSetByChangesAndToggledByWrites, isr_rdata_o[1:0] == status_q)
  `ASSERT(InterruptNeedsStatusAndBothEnables, irq_o == irq_q)

  // Flops that no port shows. `flatten` connects these nets to the flops of the same names.
  (* hierconn *) wire [31:0] \u_sync.first_q , \u_sync.second_q ;
  (* hierconn *) wire [31:0] \u_dut.u_flat.last_q ;
  (* hierconn *) wire [2:0] \u_dut.u_flat.filled_q ;
  `ASSERT(SamplesAreThoseOfThePins, {\u_sync.second_q , \u_sync.first_q } == {sample2_q, sample1_q} &&
          \u_dut.u_flat.last_q == sample3_q)
  `ASSERT(LevelsFoundAfterResetAreNoChange, \u_dut.u_flat.filled_q == {valid3_q, valid2_q, valid1_q})

  `REACH(AChangeWinsOverTheToggle, changes == 2'b01 && status_q == 2'b11 && toggles == 2'b11)
  `REACH(OnlyChannel2Interrupts, irq_o && status_q == 2'b11 && ier_i == 2'b10)
  `REACH(AWriteSetsTheStatus, status_q == 2'b10 && valid3_q && toggles == 2'b11 && changes == '0)
  `REACH(HighAfterReset, valid3_q && level == '1 && status_q == '0)

endmodule

`default_nettype wire
