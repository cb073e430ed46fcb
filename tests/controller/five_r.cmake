# Listed in CMakeLists.txt.
find_package(orocos_kdl REQUIRED)

add_unit_test(five_r_test
  SOURCES
    errata_five_r_test.cpp
    five_r_edges_test.cpp
    five_r_test.cpp
    five_r_pose5_test.cpp
    five_r_path_test.cpp
  LIBRARIES armature::controller nlohmann_json::nlohmann_json)

# An independent library as the oracle.
add_unit_test(five_r_kdl_test SOURCES five_r_kdl_test.cpp LIBRARIES armature::controller ${orocos_kdl_LIBRARIES})
target_include_directories(five_r_kdl_test SYSTEM PRIVATE ${orocos_kdl_INCLUDE_DIRS})
