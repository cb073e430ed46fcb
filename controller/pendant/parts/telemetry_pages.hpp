// The pages of the telemetry: their values, and when they are sent.
#pragma once

#include <cstdint>

#include "controller/base/units.hpp"
#include "controller/language/program/program_client.hpp"
#include "controller/motion/arm_position.hpp"
#include "controller/pendant/parts/arm_view.hpp"
#include "controller/pendant/parts/coordinates.hpp"
#include "controller/pendant/parts/pendant_line.hpp"
#include "controller/pendant/protocol/admission.hpp"

namespace armature::pendant {

class TelemetryPages {
 public:
  // What the pages show. References must outlive the object.
  struct Shown {
    Profile profile{};
    const ArmView& arm;
    const Coordinates& coordinates;
    const ArmPosition& position;
    const ProgramClient& program;
  };

  explicit TelemetryPages(const Shown& shown) noexcept : shown_{shown} {}

  // `groups` as in kPageGroups. The first ones are sent at once. A period of less than 20 ms: none are sent.
  void select(std::uint8_t groups, std::int32_t period_ms, Cycles now) noexcept;
  [[nodiscard]] bool periodic() const noexcept { return period_ > Cycles{0}; }
  // Sends the selected pages when it is time to, and when the line has room for all of them.
  void send_when_due(PendantLine& line, Cycles now) noexcept;

  [[nodiscard]] std::int32_t value(std::uint8_t page, Cycles now) const noexcept;

 private:
  [[nodiscard]] std::int32_t message(std::uint8_t page) const noexcept;

  Shown shown_;
  std::uint8_t groups_ = 0;
  Cycles period_{};  // 0: none
  Cycles next_at_{};
  std::uint8_t sequence_ = 0;
};

}  // namespace armature::pendant
