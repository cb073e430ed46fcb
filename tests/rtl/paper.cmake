# Models and tests of the blocks that only the paper's variant has.

add_verilated_model(model_pulse_width TOP pulse_width)
add_verilated_model(model_pulse_width_wrap TOP pulse_width PREFIX Vpulse_width_wrap
  PARAMETERS EmittedReset=2147483632)
add_rtl_test(pulse_width_test MODELS model_pulse_width model_pulse_width_wrap
             SOURCES pulse_width_test.cpp
                     pulse_width_registers_test.cpp)

add_verilated_model(model_encoder_switch TOP encoder_switch)
add_verilated_model(model_encoder_single TOP encoder PREFIX Vencoder_single PARAMETERS Axes=1)
add_rtl_test(encoder_switch_test MODELS model_encoder_switch model_encoder_single SOURCES encoder_switch_test.cpp)
