add_unit_test(plant_test
  SOURCES
    axis_test.cpp
    conservation_bus_test.cpp
    conservation_paper_test.cpp
    conservation_pulses_test.cpp
    encoder_test.cpp
    plant_test.cpp
    servo_drive_gear_test.cpp
    servo_drive_position_loop_test.cpp
    servo_drive_step_input_test.cpp
    servo_drive_test.cpp
  LIBRARIES armature_cosim)
