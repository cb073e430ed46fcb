add_block_lockstep(uart MODEL model_axi_uart16550 SOURCES uart/axi_uart16550.cpp uart/receiver.cpp)
