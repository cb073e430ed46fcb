// Copies the levels of the AXI4-Lite port to and from a verilated arm_soc. Model: a class that Verilator generates.
#pragma once

#include "cosim/fabric/fabric.hpp"

namespace armature::cosim {

template <class Model>
void drive_bus(Model& model, const AxiMasterPins& m) {
  model.s_axi_awaddr_i = m.awaddr;
  model.s_axi_awvalid_i = m.awvalid;
  model.s_axi_wdata_i = m.wdata;
  model.s_axi_wstrb_i = m.wstrb;
  model.s_axi_wvalid_i = m.wvalid;
  model.s_axi_bready_i = m.bready;
  model.s_axi_araddr_i = m.araddr;
  model.s_axi_arvalid_i = m.arvalid;
  model.s_axi_rready_i = m.rready;
}

template <class Model>
[[nodiscard]] AxiSlavePins sample_bus(const Model& model) {
  AxiSlavePins s;
  s.awready = model.s_axi_awready_o != 0;
  s.wready = model.s_axi_wready_o != 0;
  s.bvalid = model.s_axi_bvalid_o != 0;
  s.bresp = model.s_axi_bresp_o;
  s.arready = model.s_axi_arready_o != 0;
  s.rvalid = model.s_axi_rvalid_o != 0;
  s.rresp = model.s_axi_rresp_o;
  s.rdata = model.s_axi_rdata_o;
  return s;
}

}  // namespace armature::cosim
