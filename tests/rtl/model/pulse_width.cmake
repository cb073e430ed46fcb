add_block_lockstep(pulse_width MODEL model_pulse_width SOURCES paper/pulse_width.cpp)
