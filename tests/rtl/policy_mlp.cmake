# Models and tests of the multi-layer perceptron. Its oracles: plain arithmetic (tests/support/mlp_images.hpp), and the
# model of cosim/model for memories that contain no network.
add_verilated_model(model_policy_core TOP policy_core)
add_verilated_model(model_policy_core_4 TOP policy_core PREFIX Vpolicy_core_4 PARAMETERS Lanes=4)
add_verilated_model(model_policy_core_16 TOP policy_core PREFIX Vpolicy_core_16 PARAMETERS Lanes=16)
add_verilated_model(model_policy_mlp TOP policy_mlp)
set(network_run ${ARMATURE_ROOT}/cosim/model/policy_mlp/network_run.cpp)
add_rtl_test(policy_mlp_test MODELS model_policy_core model_policy_mlp
  SOURCES policy_core_test.cpp policy_mlp_registers_test.cpp ${network_run})
add_rtl_test(policy_lanes_test MODELS model_policy_core_4 model_policy_core_16
  SOURCES policy_lanes_test.cpp ${network_run})
