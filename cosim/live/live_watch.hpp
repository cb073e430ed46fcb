// What a live page shows of a run besides its pins: the telemetry of the last tick, the command under way, the last
// events as in log.txt, with their ticks, and what happened in the cell.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <string>

#include "controller/message/telemetry.hpp"
#include "cosim/run/run_listener.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

class LiveWatch final : public RunListener {
 public:
  static constexpr std::size_t kMaxEvents = 12;  // the oldest ones are dropped

  // The scenario must outlive this.
  explicit LiveWatch(const Scenario& scenario);
  ~LiveWatch() override;
  LiveWatch(const LiveWatch&) = delete;
  LiveWatch& operator=(const LiveWatch&) = delete;

  void on_row(const TraceRow& row, const IntegerDigest& digest) override;
  void on_event(const Event& event, const RunPlace& place) override;
  void on_action(const ScriptAction& action, const RunPlace& place) override;

  [[nodiscard]] const Telemetry& telemetry() const { return telemetry_; }
  // `joint move of 0.42 s`, `jog`, `homing of axis 3`; empty: none.
  [[nodiscard]] const std::string& command() const { return command_; }
  // `tick 5999, info: [0.300000 s] ...`, the newest last.
  [[nodiscard]] const std::deque<std::string>& events() const { return events_; }

 private:
  struct Log;

  Telemetry telemetry_;
  std::string command_;
  std::deque<std::string> events_;
  std::unique_ptr<Log> log_;
};

}  // namespace armature::cosim
