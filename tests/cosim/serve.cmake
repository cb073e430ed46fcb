# The bus server: protocol, pins, sockets, clients.
add_unit_test(serve_test
  SOURCES
    peer_closed_test.cpp
    pin_table_test.cpp
    serve_admission_test.cpp
    serve_disconnect_test.cpp
    serve_fuzz_test.cpp
    serve_interpreter_test.cpp
    serve_line_buffer_test.cpp
    serve_listener_test.cpp
    serve_server_test.cpp
    serve_token_test.cpp
    serve_waveform_test.cpp
  LIBRARIES armature_cosim)

if(NOT ARMATURE_SANITIZE AND NOT ARMATURE_COVERAGE)
  # The C example, with the strictness that a user's build may have.
  enable_language(C)
  add_executable(timer_self_test ${PROJECT_SOURCE_DIR}/cosim/serve/client/timer_self_test.c)
  set_target_properties(timer_self_test PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
  target_compile_options(timer_self_test PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Werror)
  add_test(NAME cli.serve COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_SOURCE_DIR}/test_cli_serve.py
                                  $<TARGET_FILE:armature> $<TARGET_FILE:timer_self_test>)
  set_tests_properties(cli.serve PROPERTIES TIMEOUT 600)
endif()
