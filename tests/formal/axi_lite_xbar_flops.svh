// Flops of u_dut, axi_lite_xbar_flat with `Ports` slaves, and of u_master, for the assertions of a proof that make the
// others inductive.
  (* hierconn *) wire             \u_dut.u_flat.write_busy_q , \u_dut.u_flat.read_busy_q ;
  (* hierconn *) wire [Ports-1:0] \u_dut.u_flat.write_claim_q , \u_dut.u_flat.read_claim_q ;
  (* hierconn *) wire [Ports-1:0] \u_dut.u_flat.hung ;
  (* hierconn *) wire [7:0]       \u_dut.u_flat.write_wait_q , \u_dut.u_flat.read_wait_q ;
  (* hierconn *) wire             \u_master.aw_q , \u_master.w_q , \u_master.ar_q ;
