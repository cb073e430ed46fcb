#include "cosim/model/crossbar.hpp"

#include "cosim/model/response.hpp"

namespace armature::cosim::model {
void Crossbar::edge(Cycles at, const AxiMasterPins& in, std::span<const AxiSlavePins* const> blocks) {
  const std::uint32_t hung = write_.hung | read_.hung;
  write_edge(at, in, blocks, hung);
  read_edge(at, in, blocks, hung);
}

AxiMasterPins Crossbar::to_block(std::size_t port) const {
  AxiMasterPins pins;
  if (write_port() == port) {
    pins.awaddr = held_.awaddr;
    pins.wdata = held_.wdata;
    pins.wstrb = held_.wstrb;
    pins.awvalid = held_.awvalid;
    pins.wvalid = held_.wvalid;
    pins.bready = true;
  }
  if (read_port() == port) {
    pins.araddr = held_.araddr;
    pins.arvalid = held_.arvalid;
    pins.rready = true;
  }
  return pins;
}

std::optional<std::uint8_t> Crossbar::forward(Path& path, Cycles at, std::uint32_t hung) {
  path.forwarded = true;
  if (!path.target) return kDecodeError;
  if ((hung >> *path.target & 1u) != 0) return kSlaveError;
  path.waits = true;
  path.sent_at = at;
  return std::nullopt;
}

void Crossbar::write_edge(Cycles at, const AxiMasterPins& in, std::span<const AxiSlavePins* const> blocks,
                          std::uint32_t hung) {
  const bool held = !pins_.awready && !pins_.wready;
  if (pins_.bvalid) {
    if (!in.bready) return;
    pins_.bvalid = false;
    pins_.awready = pins_.wready = true;
    write_.forwarded = false;
    return;
  }
  if (write_.waits) return take_write_response(at, *blocks[*write_.target]);
  if (held && !write_.forwarded) {
    const auto response = forward(write_, at, hung);
    held_.awvalid = held_.wvalid = !response;
    if (!response) return;
    pins_.bvalid = true;
    pins_.bresp = *response;
    return;
  }
  if (in.awvalid && pins_.awready) {
    pins_.awready = false;
    held_.awaddr = in.awaddr;
    write_.target = port_of(in.awaddr, bases_);
  }
  if (in.wvalid && pins_.wready) {
    pins_.wready = false;
    held_.wdata = in.wdata;
    held_.wstrb = in.wstrb;
  }
}

void Crossbar::take_write_response(Cycles at, const AxiSlavePins& block) {
  const bool unasked = held_.awvalid || held_.wvalid;
  if (block.awready) held_.awvalid = false;
  if (block.wready) held_.wvalid = false;
  const bool late = at - write_.sent_at >= kTimeout;
  if (!block.bvalid && !late) return;
  const bool answers = block.bvalid && !unasked;
  pins_.bvalid = true;
  pins_.bresp = answers ? block.bresp : kSlaveError;
  if (!answers) write_.hung |= 1u << *write_.target;
  write_.waits = held_.awvalid = held_.wvalid = false;
}

void Crossbar::read_edge(Cycles at, const AxiMasterPins& in, std::span<const AxiSlavePins* const> blocks,
                         std::uint32_t hung) {
  const auto respond = [this](std::uint32_t data, std::uint8_t response) {
    pins_.rvalid = true;
    pins_.rdata = data;
    pins_.rresp = response;
    read_.waits = held_.arvalid = false;
  };
  if (pins_.rvalid) {
    if (!in.rready) return;
    pins_.rvalid = false;
    pins_.arready = true;
    read_.forwarded = false;
  } else if (read_.waits) {
    const AxiSlavePins& block = *blocks[*read_.target];
    const bool unasked = held_.arvalid;
    if (block.arready) held_.arvalid = false;
    if (block.rvalid && !unasked) {
      respond(block.rdata, block.rresp);
    } else if (block.rvalid || at - read_.sent_at >= kTimeout) {
      read_.hung |= 1u << *read_.target;
      respond(0, kSlaveError);
    }
  } else if (!pins_.arready && !read_.forwarded) {
    held_.arvalid = true;
    if (const auto response = forward(read_, at, hung)) respond(0, *response);
  } else if (in.arvalid && pins_.arready) {
    pins_.arready = false;
    held_.araddr = in.araddr;
    read_.target = port_of(in.araddr, bases_);
  }
}

}  // namespace armature::cosim::model
