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
  auto& trace = *static_cast<SoftwareTrace*>(self);
  trace.code_ = code;
  for (const SoftwareSignalRow& row : kSoftwareSignals) {
    const std::string name = fmt::format("{} {}", trace.scope_, row.name);
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
  static_cast<const SoftwareTrace*>(self)->write(*buffer, true);
}

void SoftwareTrace::write_changes(void* self, VerilatedVcd::Buffer* buffer) {
  static_cast<const SoftwareTrace*>(self)->write(*buffer, false);
}

void SoftwareTrace::write(VerilatedVcd::Buffer& buffer, bool all) const {
  for (const SoftwareSignalRow& row : kSoftwareSignals) {
    const std::uint32_t* words = signals_->words(row);
    std::uint32_t* before = buffer.oldp(code_ + static_cast<std::uint32_t>(row.word));
    if (row.bits == 1) {
      const auto bit = static_cast<std::uint8_t>(*words & 1u);
      if (all) {
        buffer.fullBit(before, bit);
      } else {
        buffer.chgBit(before, bit);
      }
    } else if (row.bits <= kWordBits) {
      if (all) {
        buffer.fullIData(before, *words, row.bits);
      } else {
        buffer.chgIData(before, *words, row.bits);
      }
    } else if (all) {
      buffer.fullWData(before, words, row.bits);
    } else {
      buffer.chgWData(before, words, row.bits);
    }
  }
}

}  // namespace armature::cosim
