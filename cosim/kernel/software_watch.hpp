// Follows what the software does, for the waveform.
//
// The software acts after a clock edge. What it does appears in the waveform at the next edge, as do the pins that it
// drives.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "controller/base/tag.hpp"
#include "controller/message/event.hpp"
#include "controller/message/telemetry.hpp"
#include "cosim/cpu/processor.hpp"
#include "cosim/fabric/software_signals.hpp"
#include "cosim/scenario/command_names.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/serial/serial_burst.hpp"
#include "cosim/serial/serial_event.hpp"

namespace armature::cosim {

class SoftwareWatch {
 public:
  explicit SoftwareWatch(const Scenario& scenario);

  // The values of the last show().
  [[nodiscard]] const SoftwareSignals& signals() const { return signals_; }

  // During the whole run, because a waveform may begin later.
  void on_event(const Event& event);
  void on_serial(const SerialEvent& event);
  void on_read(std::uint32_t data) { read_data_ = data; }

  // While a waveform is open, before the time passes on. `tick`: number of the last trigger, or -1. `access`: under
  // way.
  void show(const Processor& processor, const std::optional<Processor::Access>& access, std::int64_t tick,
            MotionState state);

 private:
  void begin(std::string_view type, Tag tag);
  void end(Tag tag);
  void show_access(const Processor::Access& access);

  Variant variant_;
  CommandNames names_;
  SoftwareSignals signals_;
  std::optional<Tag> moving_;
  int homing_axes_ = 0;
  bool faulted_ = false;
  std::uint32_t read_data_ = 0;
  SerialBurst serial_in_, serial_out_;  // of the controller
  bool serial_changed_ = false;         // since the last show()
};

}  // namespace armature::cosim
