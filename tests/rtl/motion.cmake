# Pulse generation and encoder blocks.

add_verilated_model(model_pulse_gen TOP pulse_gen SOURCES pulse_train/pulse_gen.sv)
add_verilated_model(model_pulse_gen_wrap TOP pulse_gen PREFIX Vpulse_gen_wrap SOURCES pulse_train/pulse_gen.sv
                    PARAMETERS EmittedReset=2147483632)
add_rtl_test(pulse_gen_test MODELS model_pulse_gen model_pulse_gen_wrap
             SOURCES ${CMAKE_CURRENT_LIST_DIR}/pulse_gen_test.cpp
                     ${CMAKE_CURRENT_LIST_DIR}/pulse_gen_irregular_test.cpp)

set(pulse_train_sources
  pulse_train/pulse_train_reg_pkg.sv common/sync_2ff.sv common/event_time.sv axi/axi_lite_slave.sv
  pulse_train/pulse_gen.sv pulse_train/commit_bank.sv pulse_train/stop_control.sv pulse_train/pulse_train_core.sv
  pulse_train/pulse_train_reg_top.sv pulse_train/pulse_train.sv)
add_verilated_model(model_pulse_train TOP pulse_train SOURCES ${pulse_train_sources})
add_verilated_model(model_pulse_train_wrap TOP pulse_train PREFIX Vpulse_train_wrap SOURCES ${pulse_train_sources}
                    PARAMETERS EmittedReset=2147483632)
add_rtl_test(pulse_train_test MODELS model_pulse_train model_pulse_train_wrap
             SOURCES ${CMAKE_CURRENT_LIST_DIR}/pulse_train_test.cpp
                     ${CMAKE_CURRENT_LIST_DIR}/pulse_train_phase_test.cpp
                     ${CMAKE_CURRENT_LIST_DIR}/pulse_train_registers_test.cpp
                     ${CMAKE_CURRENT_LIST_DIR}/pulse_train_stop_test.cpp)

add_verilated_model(model_debounce TOP debounce SOURCES common/debounce.sv PARAMETERS Lines=18)
add_rtl_test(debounce_test MODELS model_debounce
             SOURCES ${CMAKE_CURRENT_LIST_DIR}/debounce_test.cpp ${CMAKE_CURRENT_LIST_DIR}/debounce_up_down_test.cpp)

add_verilated_model(model_quad_decoder TOP quad_decoder SOURCES encoder/quad_decoder.sv)
add_rtl_test(quad_decoder_test MODELS model_quad_decoder SOURCES ${CMAKE_CURRENT_LIST_DIR}/quad_decoder_test.cpp)

add_verilated_model(model_error_counters TOP error_counters SOURCES encoder/error_counters.sv)
add_rtl_test(error_counters_test MODELS model_error_counters
             SOURCES ${CMAKE_CURRENT_LIST_DIR}/error_counters_test.cpp)

set(encoder_core_sources
  common/sync_2ff.sv common/debounce.sv common/event_time.sv encoder/quad_decoder.sv encoder/index_check.sv
  encoder/position_counters.sv encoder/error_counters.sv encoder/encoder_core.sv)
add_verilated_model(model_encoder_core TOP encoder_core SOURCES ${encoder_core_sources})
add_verilated_model(model_encoder_core_wrap TOP encoder_core PREFIX Vencoder_core_wrap SOURCES ${encoder_core_sources}
                    PARAMETERS PositionReset=2147483645)
add_rtl_test(encoder_test MODELS model_encoder_core model_encoder_core_wrap
             SOURCES ${CMAKE_CURRENT_LIST_DIR}/encoder_test.cpp ${CMAKE_CURRENT_LIST_DIR}/encoder_index_test.cpp
                     ${CMAKE_CURRENT_LIST_DIR}/encoder_filter_test.cpp)

set(encoder_sources encoder/encoder_reg_pkg.sv ${encoder_core_sources} axi/axi_lite_slave.sv encoder/encoder_reg_top.sv
                    encoder/encoder.sv)
add_verilated_model(model_encoder TOP encoder
                    SOURCES ${encoder_sources})
add_rtl_test(encoder_registers_test MODELS model_encoder
             SOURCES ${CMAKE_CURRENT_LIST_DIR}/encoder_registers_test.cpp)
