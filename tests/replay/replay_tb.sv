// Replays a vector file (vectors.hpp) on arm_soc in a four-state simulator, from power-up with every flop X. After every
// clock every output must be known and equal to the recorded one.
//
//   vvp replay +vectors=FILE    last line: `N clocks, M differences`; the first differences one a line
module replay_tb;

  parameter PaperFabric = 0;
  localparam Reported = 20;

  reg          clk, rst_n;
  reg  [319:0] vector;
  wire [31:0]  rdata;
  wire [5:0]   step, dir, servo_on;
  wire [15:0]  gpio;
  wire [1:0]   bresp, rresp;
  wire [2:0]   irq;
  wire         awready, wready, bvalid, arready, rvalid, trigger, uart_txd, pwm;

  // Words of the vector, the first one in the highest bits.
  wire [31:0] awaddr  = vector[319:288];
  wire [31:0] wdata   = vector[287:256];
  wire [31:0] araddr  = vector[255:224];
  wire [31:0] control = vector[223:192];
  wire [31:0] pins1   = vector[191:160];
  wire [31:0] pins2   = vector[159:128];
  wire [31:0] pins3   = vector[127:96];

  arm_soc #(.PaperFabric(PaperFabric)) dut (
    .clk_i          (clk),
    .rst_ni         (rst_n),
    .clk_io_i       (clk),
    .io_active_o    (),
    .s_axi_awaddr_i (awaddr),
    .s_axi_awvalid_i(control[0]),
    .s_axi_awready_o(awready),
    .s_axi_wdata_i  (wdata),
    .s_axi_wstrb_i  (control[11:8]),
    .s_axi_wvalid_i (control[1]),
    .s_axi_wready_o (wready),
    .s_axi_bresp_o  (bresp),
    .s_axi_bvalid_o (bvalid),
    .s_axi_bready_i (control[2]),
    .s_axi_araddr_i (araddr),
    .s_axi_arvalid_i(control[3]),
    .s_axi_arready_o(arready),
    .s_axi_rdata_o  (rdata),
    .s_axi_rresp_o  (rresp),
    .s_axi_rvalid_o (rvalid),
    .s_axi_rready_i (control[4]),
    .step_o         (step),
    .dir_o          (dir),
    .servo_on_o     (servo_on),
    .enc_a_i        (pins1[5:0]),
    .enc_b_i        (pins1[11:6]),
    .enc_z_i        (pins1[17:12]),
    .home_i         (pins1[23:18]),
    .limit_pos_i    (pins1[29:24]),
    .limit_neg_i    (pins2[5:0]),
    .drive_alarm_i  (pins2[11:6]),
    .in_position_i  (pins2[17:12]),
    .estop_ni       (pins2[18]),
    .uart_rxd_i     (pins2[19]),
    .uart_txd_o     (uart_txd),
    .gpio_i         (pins3[15:0]),
    .gpio_o         (gpio),
    .capture_trig_i (pins2[20]),
    .pwm_o          (pwm),
    .trigger_o      (trigger),
    .irq_o          (irq)
  );

  reg [8*1024-1:0] path;
  integer file, clocks, differences, i;

  // One line for an output that is not as recorded; X and Z are never as recorded.
  task check(input [8*16-1:0] name, input [31:0] is, input [31:0] recorded);
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
    // The levels of an idle machine in reset: everything low but the emergency stop and the serial line.
    clk = 1'b0;
    rst_n = 1'b0;
    vector = 320'b0;
    vector[128+18] = 1'b1;
    vector[128+19] = 1'b1;
    for (i = 0; i < 16; i = i + 1) edge_of_clock;
    rst_n = 1'b1;
    while ($fscanf(file, "%h", vector) == 1) begin
      edge_of_clock;
      clocks = clocks + 1;
      check("s_axi_rdata_o", rdata, vector[95:64]);
      check("s_axi ready and valid", {27'b0, rvalid, arready, bvalid, wready, awready}, {27'b0, vector[36:32]});
      check("s_axi_bresp_o", {30'b0, bresp}, {30'b0, vector[41:40]});
      check("s_axi_rresp_o", {30'b0, rresp}, {30'b0, vector[43:42]});
      check("gpio_o", {16'b0, gpio}, {16'b0, vector[63:48]});
      check("step_o", {26'b0, step}, {26'b0, vector[5:0]});
      check("dir_o", {26'b0, dir}, {26'b0, vector[11:6]});
      check("servo_on_o", {26'b0, servo_on}, {26'b0, vector[17:12]});
      check("trigger_o", {31'b0, trigger}, {31'b0, vector[18]});
      check("uart_txd_o", {31'b0, uart_txd}, {31'b0, vector[19]});
      check("pwm_o", {31'b0, pwm}, {31'b0, vector[20]});
      check("irq_o", {29'b0, irq}, {29'b0, vector[26:24]});
    end
    $display("%0d clocks, %0d differences", clocks, differences);
    $finish;
  end

endmodule
