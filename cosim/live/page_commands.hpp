// What each message of the page does: it becomes commands of the pendant, something that happens in the cell, or a
// question to the kinematics.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/live/live_cell.hpp"
#include "cosim/live/live_kinematics.hpp"
#include "cosim/live/live_pendant.hpp"
#include "cosim/live/page_message.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

class PageCommands {
 public:
  struct Parts {
    const Scenario& scenario;
    LivePendant& pendant;
    const LiveKinematics& kinematics;
    Run& run;
    LiveCell& cell;
  };
  // What `parts` refers to must outlive this.
  explicit PageCommands(const Parts& parts)
      : scenario_{parts.scenario},
        pendant_{parts.pendant},
        kinematics_{parts.kinematics},
        run_{parts.run},
        cell_{parts.cell} {}

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
  void fault(const PageMessage& message);
  void input(const PageMessage& message);
  void hold(const PageMessage& message);
  [[nodiscard]] Json forward(const PageMessage& message) const;
  [[nodiscard]] Json inverse(const PageMessage& message) const;
  void press(const pendant::Frame& frame);
  [[nodiscard]] JointAngles joints(const PageMessage& message, const char* key) const;
  [[nodiscard]] std::size_t job_of_program() const;

  const Scenario& scenario_;
  LivePendant& pendant_;
  const LiveKinematics& kinematics_;
  Run& run_;
  LiveCell& cell_;
  std::string program_;
  bool gcode_ = false;  // it is one
};

}  // namespace armature::cosim
