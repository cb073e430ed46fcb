#include "cosim/model/bus_port.hpp"

#include <utility>

#include "cosim/model/response.hpp"

namespace armature::cosim::model {
namespace {

constexpr std::uint8_t response(bool error) {
  return error ? kSlaveError : kOkay;
}

}  // namespace

void BusPort::edge(const AxiMasterPins& in, const Answer& answer) {
  write_edge(in, answer);
  read_edge(in, answer);
}

void BusPort::write_edge(const AxiMasterPins& in, const Answer& answer) {
  const bool respond = std::exchange(executed_, strobes_.write);
  const bool error = std::exchange(werr_, answer.werr);
  strobes_.write = false;
  if (pins_.bvalid) {
    if (!in.bready) return;
    pins_.bvalid = false;
    pins_.awready = pins_.wready = true;
    return;
  }
  if (respond) {
    pins_.bvalid = true;
    pins_.bresp = response(error);
    return;
  }
  const bool address = in.awvalid && pins_.awready;
  const bool data = in.wvalid && pins_.wready;
  if (address) {
    pins_.awready = false;
    strobes_.waddr = static_cast<std::uint16_t>(in.awaddr);
  }
  if (data) {
    pins_.wready = false;
    strobes_.wdata = in.wdata;
    strobes_.wstrb = in.wstrb;
  }
  strobes_.write = (address || data) && !pins_.awready && !pins_.wready;
}

void BusPort::read_edge(const AxiMasterPins& in, const Answer& answer) {
  if (strobes_.read) {
    strobes_.read = false;
    pins_.rvalid = true;
    pins_.rdata = answer.rdata;
    pins_.rresp = response(answer.rerr);
    return;
  }
  if (pins_.rvalid) {
    if (!in.rready) return;
    pins_.rvalid = false;
    pins_.arready = true;
    return;
  }
  if (!in.arvalid || !pins_.arready) return;
  pins_.arready = false;
  strobes_.raddr = static_cast<std::uint16_t>(in.araddr);
  strobes_.read = true;
}

}  // namespace armature::cosim::model
