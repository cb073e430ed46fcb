// Writes log.txt of a run: what happens, one line for each thing, with simulated time. With wall time, two logs of the
// same run would differ.
#pragma once

#include <spdlog/logger.h>

#include <filesystem>

#include "cosim/run/event_log.hpp"
#include "cosim/run/run_listener.hpp"
#include "cosim/scenario/command_names.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

class LogListener final : public RunListener {
 public:
  // Throws spdlog::spdlog_ex when the file cannot be written. The scenario must outlive this.
  LogListener(const Scenario& scenario, const std::filesystem::path& file);
  // The lines go to the sink.
  LogListener(const Scenario& scenario, spdlog::sink_ptr sink);

  void on_row(const TraceRow& row, const IntegerDigest& digest) override;
  void on_event(const Event& event, const RunPlace& place) override { event_log_.write(event, place.at); }
  void on_action(const ScriptAction& action, const RunPlace& place) override;
  void on_signal(const Signal& signal, const RunPlace& place) override;
  void write_through() override { log_.flush(); }
  void on_end(const RunSummary& summary) override;

 private:
  void log(const CommandSpec& command, const RunPlace& place);
  void log(const FaultSpec& fault, const RunPlace& place);
  void log(const FaultEnd& end, const RunPlace& place);
  void log(const InputSpec& input, const RunPlace& place);
  void log(const StreamStep& step, const RunPlace& place);
  void log(const OutputLevel& output, const RunPlace& place);
  void log(const ServoEnables& enables, const RunPlace& place);
  void log(const BusAbort& abort, const RunPlace& place);
  void log(const PendantStepDone& step, const RunPlace& place);
  // Not logged: the events of the part are, and serial.csv has the characters.
  void log(const PartStep&, const RunPlace&) {}
  void log(const SerialEvent&, const RunPlace&) {}
  void log_facts(const RunFacts& facts);
  void log_verdicts(const RunSummary& summary);

  const Scenario& scenario_;
  CommandNames names_;
  spdlog::logger log_;
  EventLog event_log_{log_, names_};
  MotionState state_ = MotionState::kIdle;
};

}  // namespace armature::cosim
