// serial.csv and log.txt of a live session as texts. They are in the memory of the session, so that they go back with
// it.
#pragma once

#include <spdlog/sinks/ostream_sink.h>

#include <array>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <variant>

#include "cosim/run/log_listener.hpp"
#include "cosim/run/run.hpp"
#include "cosim/run/run_listener.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/serial/serial_log.hpp"

namespace armature::cosim {

class SessionRecord final : public RunListener {
 public:
  // The run must not have begun.
  SessionRecord(const Scenario& scenario, Run& run)
      : log_listener_{scenario, std::make_shared<spdlog::sinks::ostream_sink_st>(log_)} {
    serial_ << kSerialLogHeader << '\n';
    run.add(log_listener_);
    run.add(*this);
  }

  void on_signal(const Signal& signal, const RunPlace&) override {
    if (const auto* event = std::get_if<SerialEvent>(&signal)) serial_ << serial_log_row(*event) << '\n';
  }

  // Bytes that were taken so far, of serial.csv and log.txt.
  [[nodiscard]] const std::array<std::int64_t, 2>& taken() const { return taken_; }
  // What has been added since.
  [[nodiscard]] std::string take_serial() { return take(serial_, taken_[0]); }
  [[nodiscard]] std::string take_log() { return take(log_, taken_[1]); }

 private:
  static std::string take(std::ostringstream& stream, std::int64_t& taken) {
    std::string text = stream.str();
    stream.str({});
    taken += static_cast<std::int64_t>(text.size());
    return text;
  }

  std::ostringstream serial_, log_;
  LogListener log_listener_;
  std::array<std::int64_t, 2> taken_{};
};

}  // namespace armature::cosim
