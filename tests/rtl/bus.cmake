# Models and tests of the bus and the whole programmable logic.

add_verilated_model(model_axi_lite_slave TOP axi_lite_slave SOURCES axi/axi_lite_slave.sv)
add_rtl_test(axi_lite_slave_test MODELS model_axi_lite_slave SOURCES axi_lite_slave_test.cpp)

add_verilated_model(model_axi_lite_xbar TOP axi_lite_xbar SOURCES axi/axi_lite_xbar.sv
  PARAMETERS NumSlaves=3 Base=96'h43C2000043C1000042800000 Mask=96'hFFFF0000FFFF0000FFFF0000)
add_rtl_test(axi_xbar_test MODELS model_axi_lite_xbar SOURCES axi_xbar_test.cpp)

file(STRINGS ${ARMATURE_ROOT}/rtl/rtl.f arm_soc_sources REGEX "^[^/].*\\.sv$")
add_verilated_model(model_arm_soc_test TOP arm_soc SOURCES ${arm_soc_sources})
add_rtl_test(arm_soc_test MODELS model_arm_soc_test SOURCES arm_soc_test.cpp)
