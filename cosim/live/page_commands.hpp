// What each message of the page does: it becomes commands of the pendant, or a question to the kinematics.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/live/live_kinematics.hpp"
#include "cosim/live/live_pendant.hpp"
#include "cosim/live/page_message.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

class PageCommands {
 public:
  // The references must outlive this.
  PageCommands(const Scenario& scenario, LivePendant& pendant, const LiveKinematics& kinematics)
      : scenario_{scenario}, pendant_{pendant}, kinematics_{kinematics} {}

  // Returns the answer as JSON; empty: none. A message that is wrong has no effect and gets {"error": "..."}.
  [[nodiscard]] std::string answer(std::string_view text);

  // The program that was sent last; empty: none.
  [[nodiscard]] const std::string& program_name() const { return program_; }

 private:
  [[nodiscard]] Json execute(const PageMessage& message);
  void jog(const PageMessage& message);
  void send(const PageMessage& message);
  void move(const PageMessage& message);
  void load(const PageMessage& message);
  void run(const PageMessage& message);
  void breakpoint(const PageMessage& message);
  [[nodiscard]] Json forward(const PageMessage& message) const;
  [[nodiscard]] Json inverse(const PageMessage& message) const;
  void press(const pendant::Frame& frame);
  [[nodiscard]] JointAngles joints(const PageMessage& message, const char* key) const;
  [[nodiscard]] std::size_t job_of_program() const;

  const Scenario& scenario_;
  LivePendant& pendant_;
  const LiveKinematics& kinematics_;
  std::string program_;
  bool gcode_ = false;  // it is one
};

}  // namespace armature::cosim
