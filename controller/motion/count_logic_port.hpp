// LogicPort over pulse_train and the six decoders. Counts are emitted as committed; the logic reports any exception.
#pragma once

#include "controller/drivers/axi_timer.hpp"
#include "controller/drivers/encoder.hpp"
#include "controller/drivers/pulse_train.hpp"
#include "controller/hal/register_bus.hpp"
#include "controller/motion/logic_port.hpp"

namespace armature {

class CountLogicPort final : public LogicPort {
 public:
  explicit CountLogicPort(RegisterBus& bus) noexcept : timer_{bus}, pulse_train_{bus}, encoder_{bus} {}

  [[nodiscard]] bool identified() noexcept override;
  void start(const RobotModel& robot) noexcept override;
  void acknowledge() noexcept override { timer_.acknowledge(); }
  [[nodiscard]] const LogicInput& sample() noexcept override;
  [[nodiscard]] std::optional<Counts> index(std::size_t axis) noexcept override;
  void commit(const PerAxis<Pulses>& counts) noexcept override;
  void set_servo(bool on) noexcept override { pulse_train_.control(on ? PulseTrain::kAllAxes : std::uint8_t{0}, true); }
  void clear_faults() noexcept override;
  [[nodiscard]] const PerAxis<Pulses>& emitted() noexcept override;

 private:
  [[nodiscard]] Counts position(std::size_t axis, std::int32_t low) const noexcept;
  void read_residual() noexcept;
  void read_uncounted_axes() noexcept;

  AxiTimer timer_;
  PulseTrain pulse_train_;
  Encoder encoder_;
  PerAxis<Pulses> emitted_{};
  PerAxis<Pulses> residual_{};
};

}  // namespace armature
