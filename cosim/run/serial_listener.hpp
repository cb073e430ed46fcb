// Writes serial.csv of a run: what passes on the serial line.
#pragma once

#include <filesystem>
#include <variant>

#include "cosim/run/run_listener.hpp"
#include "cosim/serial/serial_log.hpp"

namespace armature::cosim {

class SerialListener final : public RunListener {
 public:
  // Throws InputError when the file cannot be written, as do write_through() and on_end().
  explicit SerialListener(const std::filesystem::path& file) : log_{file} {}

  void on_signal(const Signal& signal, const RunPlace&) override {
    if (const auto* event = std::get_if<SerialEvent>(&signal)) log_.write(*event);
  }
  void write_through() override { log_.write_through(); }
  void on_end(const RunSummary&) override { log_.close(); }

 private:
  SerialLog log_;
};

}  // namespace armature::cosim
