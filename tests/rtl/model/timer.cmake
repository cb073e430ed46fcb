add_block_lockstep(timer MODEL model_axi_timer SOURCES timer/axi_timer.cpp timer/timer_counters.cpp)
