// Where a waveform goes: a VCD file, or through the vcd2fst program (Debian package gtkwave) into an FST file. The
// verilated model knows one format per build; the converter spares a second model.
#pragma once

#include <verilated_vcd_c.h>

#include <cstdio>
#include <string>

#include "cosim/fabric/fabric.hpp"

namespace armature::cosim {

class WaveFile final : public VerilatedVcdFile {
 public:
  ~WaveFile() override { close(); }

  // Of the next open().
  void set_format(WaveFormat format) { format_ = format; }

  bool open(const std::string& name) override;
  void close() override;
  ssize_t write(const char* data, ssize_t bytes) override;

  // What went wrong with the last file, known after close(); empty when nothing did.
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  WaveFormat format_ = WaveFormat::kVcd;
  std::FILE* file_ = nullptr;
  bool pipe_ = false;
  std::string name_;
  std::string error_;
};

}  // namespace armature::cosim
