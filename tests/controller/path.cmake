add_unit_test(controller_path_test
  SOURCES
    arm_plane_test.cpp
    blend_gain_test.cpp
    blend_test.cpp
    cartesian_kink_test.cpp
    cartesian_plan_test.cpp
    cartesian_planner_test.cpp
    cartesian_refusal_test.cpp
    eased_trapezoid_test.cpp
    five_axis_refusal_test.cpp
    five_axis_turning_test.cpp
    orientation_path_test.cpp
    path_check_test.cpp
    position_path_test.cpp
  LIBRARIES armature::controller nlohmann_json::nlohmann_json)

# Random chains, judged by their numbers: minutes under sanitizers, which find nothing in them that the tests above do
# not run through.
if(NOT ARMATURE_SANITIZE)
  find_package(tomlplusplus REQUIRED)
  add_unit_test(controller_path_property_test
    SOURCES
      cartesian_campaign_test.cpp
      cartesian_hold_test.cpp
      cartesian_jerk_test.cpp
      cartesian_property_test.cpp
      robot_files.cpp
      set_point_judge_test.cpp
    LIBRARIES armature::controller tomlplusplus::tomlplusplus)
endif()
