# Models and tests of axi_timer: one timer, the pair without the bus, the whole block.
add_verilated_model(model_timer_channel TOP timer_channel)
add_rtl_test(axi_timer_channel_test MODELS model_timer_channel SOURCES axi_timer_channel_test.cpp)

add_verilated_model(model_timer_core TOP timer_core)
add_verilated_model(model_timer_core_low TOP timer_core PREFIX Vtimer_core_low
  PARAMETERS Gen0Assert=0 Gen1Assert=0 Trig0Assert=0 Trig1Assert=0)
add_rtl_test(axi_timer_core_test MODELS model_timer_core model_timer_core_low
  SOURCES axi_timer_capture_test.cpp axi_timer_cascade_test.cpp axi_timer_enall_test.cpp axi_timer_freeze_test.cpp
          axi_timer_levels_test.cpp axi_timer_pwm_test.cpp)
set(timer_model ${ARMATURE_ROOT}/cosim/model/timer/axi_timer.cpp ${ARMATURE_ROOT}/cosim/model/timer/timer_counters.cpp)
add_rtl_test(axi_timer_lockstep_test MODELS model_timer_core SOURCES axi_timer_lockstep_test.cpp ${timer_model})

add_verilated_model(model_axi_timer TOP axi_timer)
add_rtl_test(axi_timer_test MODELS model_axi_timer SOURCES axi_timer_test.cpp axi_timer_drivers_test.cpp)
