#include "cosim/bus/axi_lite_master.hpp"

#include <cassert>

namespace armature::cosim {
namespace {

constexpr std::uint8_t kOkay = 0b00;
constexpr std::uint8_t kDecerr = 0b11;

BusError decode(std::uint8_t resp) {
  if (resp == kOkay) return BusError::kNone;
  // EXOKAY is illegal on AXI4-Lite; report it as the slave's error.
  return resp == kDecerr ? BusError::kDecodeError : BusError::kSlaveError;
}

}  // namespace

AxiLiteMaster::AxiLiteMaster(const BusSpec& spec, std::uint64_t seed) : spec_{spec}, random_{seed} {}

bool AxiLiteMaster::stalled() {
  return spec_.stall_probability > 0.0 && random_.chance(spec_.stall_probability);
}

void AxiLiteMaster::start(const BusRequest& request, Cycles now) {
  assert(idle());
  request_ = request;
  response_ = {};
  addr_done_ = data_done_ = response_done_ = false;
  phase_ = Phase::kRequestLatency;
  started_ = now;
  next_event_ = now + Cycles{spec_.latency_cycles};
}

std::optional<BusResponse> AxiLiteMaster::step(Cycles now, const AxiSlavePins& slave) {
  switch (phase_) {
    case Phase::kIdle:
      return std::nullopt;
    case Phase::kResponseLatency:
      if (now < next_event_) return std::nullopt;
      phase_ = Phase::kIdle;
      return response_;
    case Phase::kRequestLatency:
      if (now < next_event_) return std::nullopt;
      phase_ = Phase::kHandshakes;
      break;
    case Phase::kHandshakes:
      record_transfers();
      if (response_done_) {
        pins_ = {};
        phase_ = Phase::kResponseLatency;
        next_event_ = now + Cycles{spec_.latency_cycles};
        if (spec_.latency_cycles > 0) return std::nullopt;
        phase_ = Phase::kIdle;
        return response_;
      }
      if (now - started_ > Cycles{spec_.timeout_cycles}) {
        pins_ = {};
        phase_ = Phase::kIdle;
        return BusResponse{BusError::kTimeout, 0};
      }
      break;
  }
  before_ = slave;
  drive_channels();
  next_event_ = now + Cycles{1};
  return std::nullopt;
}

// A channel transfers on the edge before which both VALID and READY were high.
void AxiLiteMaster::record_transfers() {
  if (request_.write) {
    if (pins_.awvalid && before_.awready) addr_done_ = true, pins_.awvalid = false;
    if (pins_.wvalid && before_.wready) data_done_ = true, pins_.wvalid = false;
    if (pins_.bready && before_.bvalid) {
      response_done_ = true;
      response_.error = decode(before_.bresp);
    }
    pins_.bready = false;
  } else {
    if (pins_.arvalid && before_.arready) addr_done_ = true, pins_.arvalid = false;
    if (pins_.rready && before_.rvalid) {
      response_done_ = true;
      response_.error = decode(before_.rresp);
      response_.data = before_.rdata;
    }
    pins_.rready = false;
  }
}

// A stall may delay the first assertion of a VALID and may deassert READY. It never deasserts a VALID.
void AxiLiteMaster::drive_channels() {
  if (request_.write) {
    if (!addr_done_ && !pins_.awvalid && !stalled()) {
      pins_.awvalid = true;
      pins_.awaddr = request_.addr;
    }
    if (!data_done_ && !pins_.wvalid && !stalled()) {
      pins_.wvalid = true;
      pins_.wdata = request_.data;
      pins_.wstrb = request_.strobes;
    }
    pins_.bready = !stalled();
  } else {
    if (!addr_done_ && !pins_.arvalid && !stalled()) {
      pins_.arvalid = true;
      pins_.araddr = request_.addr;
    }
    pins_.rready = !stalled();
  }
}

}  // namespace armature::cosim
