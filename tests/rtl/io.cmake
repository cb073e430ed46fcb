# Models and tests of general-purpose inputs and outputs.

add_verilated_model(model_axi_gpio TOP axi_gpio
  SOURCES axi_gpio/axi_gpio_reg_pkg.sv common/sync_2ff.sv axi/axi_lite_slave.sv axi_gpio/axi_gpio_reg_top.sv
          axi_gpio/axi_gpio_core.sv axi_gpio/axi_gpio.sv)
add_rtl_test(axi_gpio_test MODELS model_axi_gpio SOURCES ${CMAKE_CURRENT_LIST_DIR}/axi_gpio_test.cpp)
