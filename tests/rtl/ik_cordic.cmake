# Models and tests of the inverse kinematics by CORDIC, with the integers of cosim/model as their oracle.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(nlohmann_json REQUIRED)
set(controller ${ARMATURE_ROOT}/controller)
add_verilated_model(model_ik_core TOP ik_core)
add_verilated_model(model_ik_cordic TOP ik_cordic)
add_rtl_test(ik_cordic_test MODELS model_ik_core model_ik_cordic
  SOURCES ik_core_test.cpp ik_cordic_registers_test.cpp
          ${ARMATURE_ROOT}/cosim/model/ik_cordic/cordic.cpp ${ARMATURE_ROOT}/cosim/model/ik_cordic/ik_solver.cpp
          ${ARMATURE_ROOT}/cosim/model/ik_cordic/ik_words.cpp
          ${controller}/kinematics/fixed/fixed_point.cpp ${controller}/base/math.cpp ${controller}/base/arc_tangent.cpp)
target_link_libraries(ik_cordic_test_objects PUBLIC Eigen3::Eigen nlohmann_json::nlohmann_json)
