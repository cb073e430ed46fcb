# With the parameters of arm_soc.
add_verilated_model(model_axi_gpio_soc TOP axi_gpio PREFIX Vaxi_gpio_soc
  PARAMETERS DoutDefault=16'h0000 TriDefault=16'hFFFF AllInputs2=1'b1)
add_block_lockstep(gpio MODEL model_axi_gpio_soc SOURCES gpio/axi_gpio.cpp)
