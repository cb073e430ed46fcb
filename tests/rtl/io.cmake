# Models and tests of general-purpose inputs and outputs.

add_verilated_model(model_axi_gpio TOP axi_gpio)
add_rtl_test(axi_gpio_test MODELS model_axi_gpio SOURCES axi_gpio_test.cpp)
