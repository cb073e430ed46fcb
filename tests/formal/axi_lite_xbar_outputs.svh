// The outputs of axi_lite_xbar with `Ports` slaves, as nets of a proof.
  logic             s_axi_awready_o, s_axi_wready_o, s_axi_bvalid_o, s_axi_arready_o, s_axi_rvalid_o, active_o;
  logic [1:0]       s_axi_bresp_o, s_axi_rresp_o;
  logic [31:0]      s_axi_rdata_o;
  logic [Ports*16-1:0] m_axi_awaddr_o, m_axi_araddr_o;
  logic [Ports*32-1:0] m_axi_wdata_o;
  logic [Ports*4-1:0]  m_axi_wstrb_o;
  logic [Ports-1:0] m_axi_awvalid_o, m_axi_wvalid_o, m_axi_bready_o, m_axi_arvalid_o, m_axi_rready_o;
