// Self-checking test of a generated register file: tests/tools/reggen/rtl/example, which uses every access kind.
//
// Inputs change at the falling edge. The last line printed is "reg_top_tb: N checks, M failed".
module reg_top_tb;

  logic clk_i = 1'b0;
  always #5 clk_i = ~clk_i;

  logic        rst_ni;
  logic        reg_we_i, reg_werr_o, reg_re_i, reg_rerr_o;
  logic [15:0] reg_waddr_i, reg_raddr_i;
  logic [31:0] reg_wdata_i, reg_rdata_o;
  logic [3:0]  reg_wstrb_i;

  logic        protect_i;
  logic        ctrl_enable_o, ctrl_run_o, status_busy_i;
  logic [15:0] ctrl_limit_o, go_sequence_o;
  logic [7:0]  status_level_i, event_lost_set_i, event_lost_o, mixed_limit_o, mixed_seen_i;
  logic        event_over_set_i, event_over_o, kick_now_o, go_we_o;
  logic        mixed_hit_set_i, mixed_hit_o, mixed_shot_o;
  logic [1:0]  kick_axis_o, slot_we_o, alarm_any_set_i, alarm_any_o;
  logic [35:0] gain_value_o;
  logic [63:0] level_value_i;
  logic [15:0] slot_value_o;
  logic [7:0]  alarm_lines_set_i, alarm_lines_o;
  logic        core_we_o, core_re_o, probe_re_o;
  logic [31:0] wdata_o, core_rdata_i, probe_rdata_i;
  logic [3:0]  wstrb_o, fire_line_o;

  example_reg_top_flat dut (.*);

  localparam logic [31:0] Unmapped = 32'hBADACCE5;

  int checks = 0;
  int failures = 0;

  task automatic check(input string what, input logic [63:0] actual, input logic [63:0] expected);
    checks++;
    if (actual !== expected) begin
      failures++;
      $display("%0t: %s: got %h, expected %h", $time, what, actual, expected);
    end
  endtask

  // Returns in the cycle after the strobe.
  task automatic write_bytes(input logic [15:0] addr, input logic [31:0] data, input logic [3:0] strb);
    reg_we_i    = 1'b1;
    reg_waddr_i = addr;
    reg_wdata_i = data;
    reg_wstrb_i = strb;
    @(negedge clk_i);
    reg_we_i    = 1'b0;
    reg_wdata_i = 32'hFFFFFFFF;  // must not matter without the strobe
    reg_wstrb_i = 4'hF;
  endtask

  task automatic write(input logic [15:0] addr, input logic [31:0] data);
    write_bytes(addr, data, 4'hF);
    check("mapped write gives no error", reg_werr_o, 1'b0);
  endtask

  task automatic refuse_write(input string what, input logic [15:0] addr);
    write_bytes(addr, 32'hFFFFFFFF, 4'hF);
    check(what, reg_werr_o, 1'b1);
  endtask

  task automatic read(input logic [15:0] addr);
    reg_re_i    = 1'b1;
    reg_raddr_i = addr;
    @(negedge clk_i);
    reg_re_i    = 1'b0;
    reg_raddr_i = 16'h0;
  endtask

  task automatic expect_read(input string what, input logic [15:0] addr, input logic [31:0] expected);
    read(addr);
    check(what, {reg_rerr_o, reg_rdata_o}, {1'b0, expected});
  endtask

  task automatic check_reset;
    check("reset: bus", {reg_werr_o, reg_rerr_o, reg_rdata_o}, 34'h0);
    check("reset: ctrl", {ctrl_run_o, ctrl_limit_o, ctrl_enable_o}, {1'b1, 16'hBEEF, 1'b0});
    check("reset: flags", {event_over_o, event_lost_o, mixed_hit_o, alarm_any_o, alarm_lines_o}, 20'h0);
    check("reset: pulses", {kick_now_o, kick_axis_o, mixed_shot_o, fire_line_o, go_we_o, slot_we_o}, 11'h0);
    check("reset: others", {go_sequence_o, mixed_limit_o, slot_value_o}, {16'h0, 8'd7, 16'h5A5A});
    check("reset: array, negative", gain_value_o, {3{12'hFFB}});
  endtask

  task automatic test_byte_strobes;
    logic [31:0] expected;
    for (int strb = 0; strb < 16; strb++) begin
      write(16'h0004, 32'h800A5A51);
      write_bytes(16'h0004, 32'h7FF5A5AE, strb[3:0]);
      for (int i = 0; i < 4; i++) expected[8*i +: 8] = strb[i] ? 8'(32'h7FF5A5AE >> 8*i) : 8'(32'h800A5A51 >> 8*i);
      expected = expected & 32'h800FFFF1;
      check("rw honours byte strobes", {ctrl_run_o, 11'h0, ctrl_limit_o, 3'h0, ctrl_enable_o}, expected);
      expect_read("rw reads back", 16'h0004, expected);
    end
    repeat (3) @(negedge clk_i);
    check("rw holds while the bus is idle", {ctrl_run_o, ctrl_limit_o, ctrl_enable_o}, {1'b0, 16'h5A5A, 1'b0});
  endtask

  task automatic test_arrays;
    for (int i = 0; i < 3; i++) write(16'h0020 + 16'(4*i), 32'hFFFFF100 + i);
    check("array elements are separate", gain_value_o, 36'h102101100);
    for (int i = 0; i < 3; i++) expect_read("array reads back", 16'h0020 + 16'(4*i), 32'h100 + i);
    write_bytes(16'h0024, 32'h00000ABC, 4'b0010);
    check("array honours byte strobes", gain_value_o, 36'h102A01100);
    refuse_write("write past the end of an array", 16'h002C);
    check("write past the end changes nothing", gain_value_o, 36'h102A01100);
    level_value_i = 64'h89ABCDEF_01234567;
    expect_read("ro array, element 0", 16'h0030, 32'h01234567);
    expect_read("ro array, element 1", 16'h0034, 32'h89ABCDEF);
  endtask

  task automatic test_read_only;
    expect_read("const", 16'h0000, 32'h45580003);
    refuse_write("write to const", 16'h0000);
    status_busy_i  = 1'b1;
    status_level_i = 8'h96;
    expect_read("ro", 16'h0008, 32'h00009601);
    refuse_write("write to ro", 16'h0008);
    status_busy_i  = 1'b0;
    status_level_i = 8'h11;
    check("read data is held against its input", reg_rdata_o, 32'h00009601);
    write(16'h0014, 32'h0);
    repeat (3) @(negedge clk_i);
    check("read data is held over a write", {reg_rerr_o, reg_rdata_o}, 33'h00009601);
    mixed_seen_i = 8'hC3;
    expect_read("mixed register", 16'h0018, 32'h9000C307);
    write(16'h0018, 32'h00000022);
    expect_read("mixed register, written", 16'h0018, 32'h9000C322);
  endtask

  task automatic test_addresses;
    read(16'h0058);
    check("unmapped read", {reg_rerr_o, reg_rdata_o}, {1'b1, Unmapped});
    repeat (2) @(negedge clk_i);
    check("read error is held", {reg_rerr_o, reg_rdata_o}, {1'b1, Unmapped});
    read(16'h002C);
    check("read past the end of an array", {reg_rerr_o, reg_rdata_o}, {1'b1, Unmapped});
    read(16'h1004);
    check("upper address bits are decoded on read", {reg_rerr_o, reg_rdata_o}, {1'b1, Unmapped});
    write(16'h0014, 32'h00001234);
    refuse_write("unmapped write", 16'h0058);
    refuse_write("upper address bits are decoded on write", 16'h8014);
    check("unmapped write changes nothing", go_sequence_o, 16'h1234);
    write_bytes(16'h0015, 32'h0000AB00, 4'b0010);
    check("byte address reaches its word on write", {reg_werr_o, go_sequence_o}, 17'hAB34);
    expect_read("byte address reaches its word on read", 16'h0017, 32'h0000AB34);

    reg_re_i = 1'b1;
    reg_raddr_i = 16'h0014;
    write(16'h0014, 32'h00005678);
    reg_re_i = 1'b0;
    check("a read beside a write gives the old value", reg_rdata_o, 32'h0000AB34);
  endtask

  task automatic test_w1c;
    event_over_set_i = 1'b1;
    event_lost_set_i = 8'hA5;
    @(negedge clk_i);
    event_over_set_i = 1'b0;
    event_lost_set_i = 8'h02;
    @(negedge clk_i);
    event_lost_set_i = 8'h00;
    repeat (2) @(negedge clk_i);
    check("flags stay and gather", {event_lost_o, event_over_o}, {8'hA7, 1'b1});
    expect_read("flags read", 16'h000C, 32'h00000A71);
    write(16'h000C, 32'h0);
    check("writing 0 clears nothing", {event_lost_o, event_over_o}, {8'hA7, 1'b1});
    write_bytes(16'h000C, 32'hFFFFFFFF, 4'b1100);
    check("a byte without strobe clears nothing", {event_lost_o, event_over_o}, {8'hA7, 1'b1});
    write_bytes(16'h000C, 32'hFFFFFFFF, 4'b0010);
    check("clears the strobed byte only", {event_lost_o, event_over_o}, {8'h07, 1'b1});
    write(16'h000C, 32'h00000011);
    check("clears the bits written 1 only", {event_lost_o, event_over_o}, {8'h06, 1'b0});

    event_over_set_i = 1'b1;
    event_lost_set_i = 8'h81;
    write(16'h000C, 32'hFFFFFFFF);
    event_over_set_i = 1'b0;
    event_lost_set_i = 8'h00;
    check("set wins over clear", {event_lost_o, event_over_o}, {8'h81, 1'b1});
    write(16'h000C, 32'hFFFFFFFF);
    check("all clear", {event_lost_o, event_over_o}, 9'h0);

    mixed_hit_set_i = 1'b1;
    write(16'h0018, 32'h00000055);
    mixed_hit_set_i = 1'b0;
    check("event during a write to its register", {mixed_hit_o, mixed_limit_o}, {1'b1, 8'h55});

    alarm_any_set_i   = 2'b11;
    alarm_lines_set_i = 8'hFF;
    @(negedge clk_i);
    alarm_any_set_i   = 2'b00;
    alarm_lines_set_i = 8'h40;
    write(16'h0044, 32'h00000681);
    alarm_lines_set_i = 8'h00;
    check("array: clears one element, set wins", {alarm_any_o, alarm_lines_o}, {2'b01, 8'h6F});
    check("array: nothing else", {event_lost_o, event_over_o, mixed_hit_o}, 10'h1);
    expect_read("array: element 0", 16'h0040, 32'h00000781);
    expect_read("array: element 1", 16'h0044, 32'h00000300);
  endtask

  task automatic test_pulse;
    write(16'h0010, 32'h00000201);
    check("pulse in the next cycle", {kick_axis_o, kick_now_o}, 3'b101);
    @(negedge clk_i);
    check("pulse lasts one cycle", {kick_axis_o, kick_now_o}, 3'b000);
    write_bytes(16'h0010, 32'hFFFFFFFF, 4'b0010);
    check("pulse honours byte strobes", {kick_axis_o, kick_now_o}, 3'b110);
    write(16'h0010, 32'h00000001);
    check("back-to-back pulses do not mix", {kick_axis_o, kick_now_o}, 3'b001);
    write(16'h0004, 32'hFFFFFFFF);
    check("another register gives no pulse", {kick_axis_o, kick_now_o, mixed_shot_o, fire_line_o}, 8'h0);
    expect_read("pulse reads 0", 16'h0010, 32'h0);
    write(16'h0018, 32'h01000000);
    check("pulse in a mixed register, its flag stays", {mixed_shot_o, mixed_hit_o}, 2'b11);
    write(16'h0054, 32'h00000004);
    check("pulse of one array element", fire_line_o, 4'b1000);
    check("the mixed pulse is over", mixed_shot_o, 1'b0);
    @(negedge clk_i);
    check("array pulse lasts one cycle", fire_line_o, 4'b0000);
  endtask

  task automatic test_strobe;
    write(16'h0014, 32'h0000CAFE);
    check("strobe comes with the new value", {go_we_o, go_sequence_o}, 17'h1CAFE);
    @(negedge clk_i);
    check("strobe lasts one cycle", go_we_o, 1'b0);
    write(16'h0014, 32'h0000CAFE);
    check("strobe also without a change of value", go_we_o, 1'b1);
    write_bytes(16'h0014, 32'h0, 4'b0000);
    check("a write of no byte is no write", {reg_werr_o, go_we_o, go_sequence_o}, 18'h0CAFE);
    read(16'h0014);
    check("no strobe from a read", go_we_o, 1'b0);
    write(16'h003C, 32'h00007700);
    check("strobe of one array element", {slot_we_o, slot_value_o}, {2'b10, 16'h775A});
    check("no other strobe", go_we_o, 1'b0);
    @(negedge clk_i);
    check("array strobe lasts one cycle", slot_we_o, 2'b00);
  endtask

  task automatic test_external;
    core_rdata_i  = 32'h13579BDF;
    probe_rdata_i = 32'h2468ACE0;
    reg_we_i      = 1'b1;
    reg_waddr_i   = 16'h0048;
    reg_wdata_i   = 32'h89ABCDEF;
    reg_wstrb_i   = 4'b0110;
    reg_re_i      = 1'b1;
    reg_raddr_i   = 16'h004C;
    #1;
    check("external write strobe, same cycle", {core_we_o, wstrb_o, wdata_o}, {5'b10110, 32'h89ABCDEF});
    check("external read strobe, same cycle", {core_re_o, probe_re_o}, 2'b01);
    @(negedge clk_i);
    reg_we_i = 1'b0;
    reg_re_i = 1'b0;
    #1;
    check("external strobes end", {core_we_o, core_re_o, probe_re_o}, 3'b000);
    check("external write gives no error", reg_werr_o, 1'b0);
    probe_rdata_i = 32'h0;
    check("external data is sampled with its strobe", {reg_rerr_o, reg_rdata_o}, 33'h2468ACE0);
    expect_read("external read", 16'h0048, 32'h13579BDF);
    refuse_write("write to external ro", 16'h004C);
    reg_we_i    = 1'b1;
    reg_waddr_i = 16'h0004;
    #1;
    check("no external strobe from another register", core_we_o, 1'b0);
    @(negedge clk_i);
    reg_we_i = 1'b0;
  endtask

  task automatic expect_locked(input string what);
    logic [7:0]  limit;
    logic [15:0] slots;
    limit = mixed_limit_o;
    slots = slot_value_o;
    refuse_write(what, 16'h0018);
    check("refused write: no flag, no pulse, no value", {mixed_limit_o, mixed_hit_o, mixed_shot_o}, {limit, 2'b10});
    refuse_write(what, 16'h003C);
    check("refused write to an array: no value, no strobe", {slot_value_o, slot_we_o}, {slots, 2'b00});
    expect_read("key reads 0 while locked", 16'h001C, 32'h0);
  endtask

  task automatic expect_unlocked(input string what, input logic [7:0] value);
    write(16'h0018, {24'h0, value});
    check(what, mixed_limit_o, value);
    write(16'h0038, {16'h0, value, 8'h0});
    check(what, {slot_value_o[7:0], slot_we_o}, {value, 2'b01});
  endtask

  task automatic test_lock;
    expect_unlocked("a lock without protection has no effect", 8'h21);
    mixed_hit_set_i = 1'b1;
    @(negedge clk_i);
    mixed_hit_set_i = 1'b0;
    protect_i = 1'b1;
    expect_locked("protected after reset");
    write(16'h0014, 32'h00004321);
    check("other registers are not protected", go_sequence_o, 16'h4321);
    for (int strb = 0; strb < 15; strb++) write_bytes(16'h001C, 32'h0BADC0DE, strb[3:0]);
    expect_locked("a part of the key does not unlock");
    for (int i = 0; i < 32; i++) begin
      write(16'h001C, 32'h0BADC0DE ^ (32'h1 << i));
      expect_read("a wrong key does not unlock", 16'h001C, 32'h0);
    end
    write(16'h001C, 32'h0BADC0DE);
    expect_read("key reads 1 while unlocked", 16'h001C, 32'h1);
    expect_unlocked("the key unlocks", 8'h43);
    write(16'h0014, 32'h0BADC0DE);
    expect_unlocked("unlocked until the key register is written", 8'h65);
    write(16'h001C, 32'h0);
    expect_locked("any other word locks");
    write(16'h001C, 32'h0BADC0DE);
    write_bytes(16'h001C, 32'h0BADC0DE, 4'b0000);
    expect_locked("a write of no byte locks");
    mixed_hit_set_i = 1'b1;
    write(16'h0014, 32'h0);
    mixed_hit_set_i = 1'b0;
    check("events still set the flags of a protected register", mixed_hit_o, 1'b1);
    write(16'h001C, 32'h0BADC0DE);
    rst_ni = 1'b0;
    @(negedge clk_i);
    rst_ni = 1'b1;
    expect_read("reset locks", 16'h001C, 32'h0);
    protect_i = 1'b0;
  endtask

  initial begin
    {rst_ni, reg_we_i, reg_re_i, protect_i} = '0;
    {reg_waddr_i, reg_raddr_i, reg_wdata_i, reg_wstrb_i} = '0;
    {status_busy_i, status_level_i, mixed_seen_i, level_value_i, core_rdata_i, probe_rdata_i} = '0;
    {event_over_set_i, event_lost_set_i, mixed_hit_set_i, alarm_any_set_i, alarm_lines_set_i} = '0;
    repeat (2) @(negedge clk_i);
    rst_ni = 1'b1;
    check_reset();
    test_read_only();
    test_byte_strobes();
    test_arrays();
    test_addresses();
    test_w1c();
    test_pulse();
    test_strobe();
    test_external();
    test_lock();
    rst_ni = 1'b0;
    @(negedge clk_i);
    check_reset();
    $display("reg_top_tb: %0d checks, %0d failed", checks, failures);
    $finish;
  end

endmodule
