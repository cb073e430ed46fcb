# Models and tests of general-purpose inputs and outputs.

add_verilated_model(model_axi_gpio TOP axi_gpio)
add_rtl_test(axi_gpio_test MODELS model_axi_gpio SOURCES axi_gpio_test.cpp)

add_verilated_model(model_axi_gpio_preset TOP axi_gpio PREFIX Vaxi_gpio_preset
  PARAMETERS DoutDefault=16'hA5C3 TriDefault=16'h00FF DoutDefault2=16'h1234 TriDefault2=16'h0F0F)
add_verilated_model(model_axi_gpio_fixed TOP axi_gpio PREFIX Vaxi_gpio_fixed
  PARAMETERS AllInputs=1'b1 AllOutputs2=1'b1 DoutDefault2=16'h8001)
add_rtl_test(axi_gpio_parameters_test MODELS model_axi_gpio_preset model_axi_gpio_fixed
  SOURCES axi_gpio_parameters_test.cpp)
