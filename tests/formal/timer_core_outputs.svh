// The outputs of timer_core, as nets of a proof.
  logic [31:0] tcsr0_rdata_o, tlr0_rdata_o, tcr0_rdata_o, tcsr1_rdata_o, tlr1_rdata_o, tcr1_rdata_o;
  logic [1:0]  generate_o;
  logic        pwm_o, irq_o, active_o;
