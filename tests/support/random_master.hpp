// A master of an AXI4-Lite port that does what the protocol allows, at random.
#pragma once

#include <cstdint>
#include <optional>

#include "cosim/fabric/fabric.hpp"
#include "tests/support/split_mix.hpp"

namespace armature::test {

// A request of the random master.
struct BusTraffic {
  std::uint32_t addr = 0;
  std::uint32_t data = 0;
  std::uint8_t wstrb = 0xF;
};

// A master that keeps the rules of AXI4-Lite and else does as it likes: VALID stays until READY, each direction has one
// transaction at a time, READY of the responses comes and goes.
class RandomMaster {
 public:
  explicit RandomMaster(SplitMix& random) : random_{random} {}

  [[nodiscard]] const cosim::AxiMasterPins& pins() const { return pins_; }
  [[nodiscard]] bool writes() const { return write_.has_value(); }
  [[nodiscard]] bool reads() const { return reading_; }

  void reset() {
    pins_ = {};
    write_.reset();
    reading_ = address_due_ = data_due_ = address_of_read_due_ = false;
  }

  // Only while not writes() or reads().
  void write(const BusTraffic& request) {
    write_ = request;
    address_due_ = data_due_ = true;
  }
  void read(std::uint32_t addr) {
    reading_ = address_of_read_due_ = true;
    pins_.araddr = addr;
  }

  // After an edge, with the levels that the slave had before it.
  void edge(const cosim::AxiSlavePins& slave) {
    if (pins_.awvalid && slave.awready) pins_.awvalid = address_due_ = false;
    if (pins_.wvalid && slave.wready) pins_.wvalid = data_due_ = false;
    if (pins_.arvalid && slave.arready) pins_.arvalid = address_of_read_due_ = false;
    if (pins_.bready && slave.bvalid) write_.reset();
    if (pins_.rready && slave.rvalid) reading_ = false;
    pins_.bready = pins_.rready = false;
  }
  // Levels for the next edge. `lazy`: 1 of so many chances is taken.
  void drive(std::uint32_t lazy) {
    const auto takes = [&] { return random_.below(lazy) == 0; };
    if (write_ && address_due_ && !pins_.awvalid && takes()) {
      pins_.awvalid = true;
      pins_.awaddr = write_->addr;
    }
    if (write_ && data_due_ && !pins_.wvalid && takes()) {
      pins_.wvalid = true;
      pins_.wdata = write_->data;
      pins_.wstrb = write_->wstrb;
    }
    if (reading_ && address_of_read_due_ && takes()) pins_.arvalid = true;
    if (write_) pins_.bready = takes();
    if (reading_) pins_.rready = takes();
  }

 private:
  SplitMix& random_;
  cosim::AxiMasterPins pins_;
  std::optional<BusTraffic> write_;
  bool reading_ = false;
  bool address_due_ = false, data_due_ = false, address_of_read_due_ = false;
};

}  // namespace armature::test
