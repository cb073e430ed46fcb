// What the motors truly did in a run, tick by tick: the run without faults, with which the others are compared.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "controller/base/axes.hpp"
#include "cosim/run/run_listener.hpp"

namespace armature::cosim {

// Ticks without a count of any motor, after which the arm is at rest.
inline constexpr std::size_t kRestRows = 100;

// At a trigger.
struct TruePoint {
  std::int64_t cycle = 0;
  PerAxis<std::int64_t> motor_counts{};
  PerAxis<std::int64_t> pin_pulses{};
  std::uint8_t servo_on = 0;
  friend bool operator==(const TruePoint&, const TruePoint&) = default;
};

struct TruePath {
  std::vector<TruePoint> points;
  std::int64_t refusals = 0;  // commands that the controller has refused
};

class TruePathRecorder final : public RunListener {
 public:
  void on_row(const TraceRow& row, const IntegerDigest&) override {
    const bool rests = !path_.points.empty() && path_.points.back().motor_counts == row.motor_counts;
    rest_rows_ = rests ? rest_rows_ + 1 : 0;
    path_.points.push_back({row.cycle, row.motor_counts, row.pin_pulses, servo_on_});
  }
  void on_event(const Event& event, const RunPlace&) override {
    if (std::holds_alternative<MoveRefused>(event)) ++path_.refusals;
  }
  void on_signal(const Signal& signal, const RunPlace&) override {
    if (const auto* servos = std::get_if<ServoEnables>(&signal)) servo_on_ = servos->levels;
  }

  [[nodiscard]] const TruePath& path() const { return path_; }
  [[nodiscard]] bool motors_stand() const { return rest_rows_ >= kRestRows; }

 private:
  TruePath path_;
  std::uint8_t servo_on_ = 0;
  std::size_t rest_rows_ = 0;
};

}  // namespace armature::cosim
