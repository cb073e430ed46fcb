# Models and tests of the bus and the whole programmable logic.

add_verilated_model(model_axi_lite_slave TOP axi_lite_slave)
add_rtl_test(axi_lite_slave_test MODELS model_axi_lite_slave SOURCES axi_lite_slave_test.cpp)

add_verilated_model(model_axi_lite_xbar TOP axi_lite_xbar
  PARAMETERS NumSlaves=3 Base=96'h43C2000043C1000042800000 Mask=96'hFFFF0000FFFF0000FFFF0000)
add_rtl_test(axi_xbar_test MODELS model_axi_lite_xbar SOURCES axi_xbar_test.cpp axi_xbar_hang_test.cpp)

add_verilated_model(model_arm_soc_test TOP arm_soc)
add_rtl_test(arm_soc_test MODELS model_arm_soc_test
  SOURCES arm_soc_test.cpp arm_soc_axes_test.cpp arm_soc_reset_test.cpp)
add_verilated_model(model_arm_soc_paper_test TOP arm_soc PREFIX Varm_soc_paper_test PARAMETERS PaperFabric=1'b1)
add_rtl_test(arm_soc_paper_test MODELS model_arm_soc_paper_test SOURCES arm_soc_paper_test.cpp)

add_verilated_model(model_axi_uart16550 TOP axi_uart16550)
add_rtl_test(axi_uart16550_test MODELS model_axi_uart16550
  SOURCES uart_registers_test.cpp uart_transmit_test.cpp uart_receive_test.cpp
          uart_receive_race_test.cpp uart_drift_test.cpp uart_interrupt_test.cpp uart_driver_test.cpp
          uart_random_test.cpp)

# The same block with the driver of the controller and the serial line of the simulation.
find_package(fmt REQUIRED)
set(serial ${ARMATURE_ROOT}/cosim/serial)
add_rtl_test(uart_serial_line_test MODELS model_axi_uart16550
  SOURCES uart_serial_line_test.cpp ${ARMATURE_ROOT}/controller/drivers/axi_uart16550.cpp
          ${serial}/line_receiver.cpp ${serial}/line_sender.cpp ${serial}/line_time.cpp ${serial}/serial_format.cpp
          ${serial}/serial_line.cpp ${serial}/serial_log.cpp ${serial}/serial_script.cpp
          ${ARMATURE_ROOT}/cosim/text/input_error.cpp
          ${ARMATURE_ROOT}/cosim/text/printable.cpp)
target_link_libraries(uart_serial_line_test_objects PUBLIC fmt::fmt)
