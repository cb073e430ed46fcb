add_block_lockstep(pulse_train MODEL model_pulse_train
  SOURCES pulse_train/pulse_axis.cpp pulse_train/pulse_train.cpp)
