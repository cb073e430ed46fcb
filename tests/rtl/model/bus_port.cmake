add_rtl_test(bus_port_lockstep_test MODELS model_axi_lite_slave
  SOURCES model/bus_port_lockstep_test.cpp ${ARMATURE_ROOT}/cosim/model/bus_port.cpp)
