#include "cosim/fabric/software_trace.hpp"

#include <fmt/format.h>

#include <string>

namespace armature::cosim {
namespace {

constexpr int kWordBits = 32;

}  // namespace

void SoftwareTrace::add_to(VerilatedVcdC& vcd, const SoftwareSignals& signals) {
  signals_ = &signals;
  vcd.spTrace()->addInitCb(&declare, this);
  vcd.spTrace()->addFullCb(&write_all, this);
  vcd.spTrace()->addChgCb(&write_changes, this);
}

void SoftwareTrace::declare(void* self, VerilatedVcd* vcd, std::uint32_t code) {
  static_cast<SoftwareTrace*>(self)->code_ = code;
  for (const SoftwareSignalRow& row : kSoftwareSignals) {
    const std::string name = fmt::format("software {}", row.name);  // a blank ends the name of a scope
    const std::uint32_t first = code + static_cast<std::uint32_t>(row.word);
    if (row.bits == 1) {
      vcd->declBit(first, name.c_str(), false, -1);
    } else if (row.bits <= kWordBits) {
      vcd->declBus(first, name.c_str(), false, -1, row.bits - 1, 0);
    } else {
      vcd->declArray(first, name.c_str(), false, -1, row.bits - 1, 0);
    }
  }
}

void SoftwareTrace::write_all(void* self, VerilatedVcd::Buffer* buffer) {
  const auto& trace = *static_cast<const SoftwareTrace*>(self);
  for (const SoftwareSignalRow& row : kSoftwareSignals) {
    const std::uint32_t* words = trace.signals_->words(row);
    std::uint32_t* before = buffer->oldp(trace.code_ + static_cast<std::uint32_t>(row.word));
    if (row.bits == 1) {
      buffer->fullBit(before, static_cast<std::uint8_t>(*words & 1u));
    } else if (row.bits <= kWordBits) {
      buffer->fullIData(before, *words, row.bits);
    } else {
      buffer->fullWData(before, words, row.bits);
    }
  }
}

void SoftwareTrace::write_changes(void* self, VerilatedVcd::Buffer* buffer) {
  const auto& trace = *static_cast<const SoftwareTrace*>(self);
  for (const SoftwareSignalRow& row : kSoftwareSignals) {
    const std::uint32_t* words = trace.signals_->words(row);
    std::uint32_t* before = buffer->oldp(trace.code_ + static_cast<std::uint32_t>(row.word));
    if (row.bits == 1) {
      buffer->chgBit(before, static_cast<std::uint8_t>(*words & 1u));
    } else if (row.bits <= kWordBits) {
      buffer->chgIData(before, *words, row.bits);
    } else {
      buffer->chgWData(before, words, row.bits);
    }
  }
}

}  // namespace armature::cosim
