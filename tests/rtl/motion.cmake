# Models and tests of the pulse generation and encoder blocks.

add_verilated_model(model_pulse_gen TOP pulse_gen)
add_verilated_model(model_pulse_gen_wrap TOP pulse_gen PREFIX Vpulse_gen_wrap PARAMETERS EmittedReset=2147483632)
add_rtl_test(pulse_gen_test MODELS model_pulse_gen model_pulse_gen_wrap
             SOURCES pulse_gen_test.cpp
                     pulse_gen_irregular_test.cpp)

add_verilated_model(model_pulse_train TOP pulse_train)
add_verilated_model(model_pulse_train_wrap TOP pulse_train PREFIX Vpulse_train_wrap
  PARAMETERS EmittedReset=2147483632 UnderrunsReset=32'hFFFFFFFE)
add_rtl_test(pulse_train_test MODELS model_pulse_train model_pulse_train_wrap
             SOURCES pulse_train_test.cpp
                     pulse_train_phase_test.cpp
                     pulse_train_registers_test.cpp
                     pulse_train_stop_test.cpp
                     pulse_train_watchdog_test.cpp)

add_verilated_model(model_debounce TOP debounce PARAMETERS Lines=18)
add_rtl_test(debounce_test MODELS model_debounce SOURCES debounce_test.cpp debounce_up_down_test.cpp)

add_verilated_model(model_quad_decoder TOP quad_decoder)
add_rtl_test(quad_decoder_test MODELS model_quad_decoder SOURCES quad_decoder_test.cpp)

add_verilated_model(model_error_counters TOP error_counters)
add_rtl_test(error_counters_test MODELS model_error_counters SOURCES error_counters_test.cpp)

add_verilated_model(model_encoder_core TOP encoder_core)
add_verilated_model(model_encoder_core_wrap TOP encoder_core PREFIX Vencoder_core_wrap
  PARAMETERS PositionReset=2147483645)
add_rtl_test(encoder_test MODELS model_encoder_core model_encoder_core_wrap
             SOURCES encoder_test.cpp encoder_index_test.cpp
                     encoder_filter_test.cpp)

add_verilated_model(model_encoder TOP encoder)
add_rtl_test(encoder_registers_test MODELS model_encoder SOURCES encoder_registers_test.cpp)
