# Robot files and the kinematics that they describe.
find_package(nlohmann_json REQUIRED)
find_package(orocos_kdl REQUIRED)
add_unit_test(kinematics_files_test
  SOURCES
    pose_files_test.cpp
    robot_kdl_test.cpp
    robot_model_test.cpp
    robot_reference_test.cpp
    robot_round_trip_test.cpp
    robot_vendor_test.cpp
  LIBRARIES armature_cosim nlohmann_json::nlohmann_json ${orocos_kdl_LIBRARIES})
