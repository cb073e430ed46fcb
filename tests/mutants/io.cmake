# Broken general-purpose inputs and outputs.

add_rtl_mutant(NAME gpio_status_write_clears FILE axi_gpio/axi_gpio_core.sv TEST axi_gpio_test
  FROM "(isr_o ^ toggle_i)"
  TO "(isr_o & ~toggle_i)"
  KILLED_BY Stalls/AxiGpio.StatusTogglesOnWriteOfItsLowByteOnly/*)
add_rtl_mutant(NAME gpio_acknowledge_wins FILE axi_gpio/axi_gpio_core.sv TEST axi_gpio_test
  FROM "(isr_o ^ toggle_i) | {changed, 1'b0};"
  TO "(isr_o | {changed, 1'b0}) ^ toggle_i;"
  KILLED_BY AxiGpioTiming.*)
add_rtl_mutant(NAME gpio_rising_edges_only FILE axi_gpio/axi_gpio_core.sv TEST axi_gpio_test
  FROM "filled_q[2] && gpio_i != last_q;"
  TO "filled_q[2] && (gpio_i & ~last_q) != '0;"
  KILLED_BY Stalls/AxiGpio.EveryInputChangeSetsTheStatus*)
add_rtl_mutant(NAME gpio_first_level_is_a_change FILE axi_gpio/axi_gpio_core.sv TEST axi_gpio_test
  FROM "filled_q[2] && gpio_i"
  TO "filled_q[0] && gpio_i"
  KILLED_BY Stalls/AxiGpio.LevelsFoundAfterResetAreNoChange/*)
add_rtl_mutant(NAME gpio_interrupt_without_global_enable FILE axi_gpio/axi_gpio_core.sv TEST axi_gpio_test
  FROM "enable_i && (isr_o"
  TO "(enable_i || ier_i != '0) && (isr_o"
  KILLED_BY Stalls/AxiGpio.InterruptNeedsStatusEnableAndGlobalEnable/*)
add_rtl_mutant(NAME gpio_tri_ignored FILE axi_gpio/axi_gpio_core.sv TEST axi_gpio_test
  FROM "data_i & ~tri_i;"
  TO "data_i | (tri_i & ~tri_i);"
  KILLED_BY Stalls/AxiGpio.ReleasedOutputIsLowAndKeepsItsData/*)
add_rtl_mutant(NAME gpio_status_ignores_strobes FILE axi_gpio/axi_gpio.sv TEST axi_gpio_test
  FROM "(isr_we && isr_wstrb[0])"
  TO "isr_we"
  KILLED_BY Stalls/AxiGpio.StatusTogglesOnWriteOfItsLowByteOnly/*)
add_rtl_mutant(NAME gpio_reserved_word_errs FILE axi_gpio/axi_gpio.sv TEST axi_gpio_test
  FROM "reserved ? axi_gpio_reg_pkg::ReservedOffset : bus_raddr;"
  TO "bus_raddr;"
  KILLED_BY Stalls/AxiGpio.WordsWithoutARegister*)
add_rtl_mutant(NAME gpio_ignored_write_errs FILE axi_gpio/axi_gpio.sv TEST axi_gpio_test
  FROM "(reg_werr && !in_map_write)"
  TO "(reg_werr)"
  KILLED_BY Stalls/AxiGpio.WordsWithoutARegister*:Stalls/AxiGpio.InputsReadBitByBitAndIgnoreWrites/*)
