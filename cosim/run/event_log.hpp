// The events of the controller as lines of log.txt.
#pragma once

#include <spdlog/logger.h>

#include <string>

#include "controller/base/members.hpp"
#include "controller/base/units.hpp"
#include "controller/message/event.hpp"
#include "cosim/report/format/json/message_json.hpp"
#include "cosim/scenario/command_names.hpp"

namespace armature::cosim {

// `[0.123456 s]`: log lines have simulated time.
[[nodiscard]] std::string stamp(Cycles now);

class EventLog {
 public:
  // References must outlive this.
  EventLog(spdlog::logger& log, const CommandNames& names) : log_{log}, names_{names} {}

  void write(const Event& event, Cycles now);

 private:
  void log(const MoveStarted& move, Cycles now);
  void log(const MoveRefused& refusal, Cycles now);
  void log(const IoDone& done, Cycles now);
  void log(const JogStarted& jog, Cycles now);
  void log(const JogEnded& jog, Cycles now);
  void log(const HomingStarted& axis, Cycles now);
  void log(const HomingEnded& axis, Cycles now);
  void log(const Faulted& fault, Cycles now);
  void log(const StreamEnded& stream, Cycles now);
  void log(const PartFollowed& part, Cycles now);
  void log(const ProgramNoted& note, Cycles now);
  void log(const OutputSwitched& output, Cycles now);
  // Not logged: the change of the state is.
  void log(const MoveFinished&, Cycles) {}
  void log(const FaultCleared&, Cycles) {}
  // An event without a sentence of its own: its members.
  template <HasMembers T>
  void log(const T& event, Cycles now) {
    log_.info("{} {} {}", stamp(now), type_name_of<T>(), message_json(event).dump());
  }

  spdlog::logger& log_;
  const CommandNames& names_;
};

}  // namespace armature::cosim
