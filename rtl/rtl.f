// Every synthesizable source of arm_soc, by dependency level. A file uses only files of lower levels.
// One path per line, relative to this folder. Read by CMake, tools/check_rtl, proofs and synthesis.
// The include path is common/ (assert.svh, arm_soc_pins.svh).

// Level 0: packages of constants
soc/soc_map_pkg.sv
axi_gpio/axi_gpio_reg_pkg.sv
axi_timer/axi_timer_reg_pkg.sv
axi_uart16550/axi_uart16550_reg_pkg.sv
encoder/encoder_reg_pkg.sv
encoder_switch/encoder_switch_reg_pkg.sv
ik_cordic/ik_cordic_reg_pkg.sv
ik_cordic/ik_pkg.sv
policy_mlp/policy_mlp_reg_pkg.sv
pulse_train/pulse_train_reg_pkg.sv
pulse_width/pulse_width_reg_pkg.sv

// Level 1: modules without instances
common/sync_2ff.sv
common/debounce.sv
common/event_time.sv
axi/axi_lite_slave.sv
axi/axi_lite_xbar.sv
axi_gpio/axi_gpio_reg_top.sv
axi_gpio/gpio_channel.sv
axi_timer/axi_timer_reg_top.sv
axi_timer/timer_counter.sv
axi_timer/timer_pwm.sv
axi_uart16550/axi_uart16550_reg_top.sv
axi_uart16550/uart_baud.sv
axi_uart16550/uart_fifo.sv
axi_uart16550/uart_interrupt.sv
axi_uart16550/uart_modem.sv
axi_uart16550/uart_rx.sv
axi_uart16550/uart_rx_status.sv
axi_uart16550/uart_tx.sv
encoder/encoder_reg_top.sv
encoder/error_counters.sv
encoder/index_check.sv
encoder/position_counters.sv
encoder/quad_decoder.sv
encoder_switch/encoder_switch_reg_top.sv
ik_cordic/cordic_lane.sv
ik_cordic/cordic_main.sv
ik_cordic/ik_cordic_reg_top.sv
ik_cordic/ik_multiplier.sv
ik_cordic/ik_program.sv
ik_cordic/ik_results.sv
ik_cordic/ik_root.sv
policy_mlp/policy_crc.sv
policy_mlp/policy_memory.sv
policy_mlp/policy_mlp_reg_top.sv
policy_mlp/policy_products.sv
policy_mlp/policy_requantise.sv
policy_mlp/policy_values.sv
pulse_train/commit_bank.sv
pulse_train/pulse_gen.sv
pulse_train/pulse_train_reg_top.sv
pulse_train/stop_control.sv
pulse_width/pulse_width_gen.sv
pulse_width/pulse_width_reg_top.sv

// Level 2: cores, which have no bus port, and their parts
axi_gpio/axi_gpio_core.sv
axi_timer/timer_channel.sv
axi_timer/timer_core.sv
axi_uart16550/uart_core.sv
encoder/encoder_core.sv
ik_cordic/cordic.sv
ik_cordic/ik_core.sv
policy_mlp/policy_neuron.sv
policy_mlp/policy_core.sv
pulse_train/pulse_train_core.sv
pulse_width/pulse_width_core.sv

// Level 3: blocks, each with an AXI4-Lite port, a register file and a core
axi_gpio/axi_gpio.sv
axi_timer/axi_timer.sv
axi_uart16550/axi_uart16550.sv
encoder/encoder.sv
encoder_switch/encoder_switch.sv
ik_cordic/ik_cordic.sv
policy_mlp/policy_mlp.sv
pulse_train/pulse_train.sv
pulse_width/pulse_width.sv

// Level 4: the whole programmable logic
soc/arm_soc.sv
