# The serial line: bit level, log, the host's side of it.
add_unit_test(serial_test
  SOURCES
    line_receiver_test.cpp
    line_sender_test.cpp
    serial_host_test.cpp
    serial_line_test.cpp
    serial_log_test.cpp
  LIBRARIES armature_cosim)
