#include "cosim/fabric/pin_trace.hpp"

#include <fmt/format.h>

#include <string>

#include "cosim/logic/pin_table.hpp"

namespace armature::cosim {

PinTrace::PinTrace() {
  vcd_.set_time_unit("1ns");
  vcd_.set_time_resolution("1ns");
  vcd_.spTrace()->addInitCb(&declare, this);
  vcd_.spTrace()->addFullCb(&write_all, this);
  vcd_.spTrace()->addChgCb(&write_changes, this);
}

PinTrace::~PinTrace() {
  if (vcd_.isOpen()) vcd_.close();
}

void PinTrace::open(const std::filesystem::path& file, WaveFormat format) {
  close();
  file_.set_format(format);
  vcd_.open(file.c_str());
  if (!vcd_.isOpen()) throw WaveError(file.string() + ": cannot write the waveform file");
}

void PinTrace::close() {
  if (!vcd_.isOpen()) return;
  vcd_.close();
  if (const auto& error = file_.error(); !error.empty()) throw WaveError(error);
}

void PinTrace::dump(Cycles cycle, const SocInputs& inputs, const SocOutputs& outputs) {
  inputs_ = inputs;
  outputs_ = outputs;
  vcd_.dump(static_cast<std::uint64_t>(cycle.value()) * kCycleNs);
}

void PinTrace::declare(void* self, VerilatedVcd* vcd, std::uint32_t code) {
  static_cast<PinTrace*>(self)->code_ = code;
  for (const Pin& pin : pins()) {
    const std::string name = fmt::format("top arm_soc {}", pin.name);  // a blank ends the name of a scope
    if (pin.bits == 1) {
      vcd->declBit(code++, name.c_str(), false, -1);
    } else {
      vcd->declBus(code++, name.c_str(), false, -1, pin.bits - 1, 0);
    }
  }
}

void PinTrace::write_all(void* self, VerilatedVcd::Buffer* buffer) {
  const auto& trace = *static_cast<const PinTrace*>(self);
  std::uint32_t* before = buffer->oldp(trace.code_);
  for (const Pin& pin : pins()) {
    const std::uint32_t level = pin.get(trace.inputs_, trace.outputs_);
    if (pin.bits == 1) {
      buffer->fullBit(before++, static_cast<std::uint8_t>(level));
    } else {
      buffer->fullIData(before++, level, pin.bits);
    }
  }
}

void PinTrace::write_changes(void* self, VerilatedVcd::Buffer* buffer) {
  const auto& trace = *static_cast<const PinTrace*>(self);
  std::uint32_t* before = buffer->oldp(trace.code_);
  for (const Pin& pin : pins()) {
    const std::uint32_t level = pin.get(trace.inputs_, trace.outputs_);
    if (pin.bits == 1) {
      buffer->chgBit(before++, static_cast<std::uint8_t>(level));
    } else {
      buffer->chgIData(before++, level, pin.bits);
    }
  }
}

}  // namespace armature::cosim
