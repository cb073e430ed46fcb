# Listed in CMakeLists.txt.
find_package(orocos_kdl REQUIRED)

add_unit_test(six_r_test
  SOURCES
    arm_test.cpp
    branch_choice_test.cpp
    errata_six_r_test.cpp
    jacobian_test.cpp
    six_r_test.cpp
    six_r_track_test.cpp
    transform_test.cpp
  LIBRARIES armature::controller nlohmann_json::nlohmann_json)

# An independent library as the oracle.
add_unit_test(six_r_kdl_test SOURCES six_r_kdl_test.cpp LIBRARIES armature::controller ${orocos_kdl_LIBRARIES}
  nlohmann_json::nlohmann_json)
target_include_directories(six_r_kdl_test SYSTEM PRIVATE ${orocos_kdl_INCLUDE_DIRS})
