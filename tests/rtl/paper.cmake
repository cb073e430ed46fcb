# Models and tests of the blocks that only the paper's fabric has.

set(pulse_width_sources
  pulse_width/pulse_width_reg_pkg.sv common/sync_2ff.sv common/event_time.sv axi/axi_lite_slave.sv
  pulse_train/stop_control.sv pulse_width/pulse_width_gen.sv pulse_width/pulse_width_core.sv
  pulse_width/pulse_width_reg_top.sv pulse_width/pulse_width.sv)
add_verilated_model(model_pulse_width TOP pulse_width SOURCES ${pulse_width_sources})
add_verilated_model(model_pulse_width_wrap TOP pulse_width PREFIX Vpulse_width_wrap SOURCES ${pulse_width_sources}
                    PARAMETERS EmittedReset=2147483632)
add_rtl_test(pulse_width_test MODELS model_pulse_width model_pulse_width_wrap
             SOURCES ${CMAKE_CURRENT_LIST_DIR}/pulse_width_test.cpp
                     ${CMAKE_CURRENT_LIST_DIR}/pulse_width_registers_test.cpp)

add_verilated_model(model_encoder_switch TOP encoder_switch
  SOURCES encoder_switch/encoder_switch_reg_pkg.sv axi/axi_lite_slave.sv encoder_switch/encoder_switch_reg_top.sv
          encoder_switch/encoder_switch.sv)
add_verilated_model(model_encoder_single TOP encoder PREFIX Vencoder_single SOURCES ${encoder_sources} PARAMETERS Axes=1)
add_rtl_test(encoder_switch_test MODELS model_encoder_switch model_encoder_single
             SOURCES ${CMAKE_CURRENT_LIST_DIR}/encoder_switch_test.cpp)
