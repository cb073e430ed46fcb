// A run that a page shows and drives: the simulation, its pendant, and what the page is told.
//
// The caller advances it and knows real time; the session decides by it only whether somebody is at the page. What
// reached the pendant's line is in the run's serial log, so the run can be repeated without the page.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

#include "cosim/live/live_cell.hpp"
#include "cosim/live/live_kinematics.hpp"
#include "cosim/live/live_pendant.hpp"
#include "cosim/live/live_watch.hpp"
#include "cosim/live/page_commands.hpp"
#include "cosim/live/web_server.hpp"
#include "cosim/run/run.hpp"
#include "cosim/scenario/scenario.hpp"

namespace armature::cosim {

class LiveSession final : public WebApplication {
 public:
  using Clock = std::chrono::steady_clock;
  // The page sends something every 100 ms. Without a message for this time nobody is there: the page is frozen, or
  // behind another window, where its operator could not see the arm. A closed page is noticed at once, and a jog ends
  // 150 ms after its last message.
  static constexpr std::chrono::milliseconds kPatience{1'000};

  // The scenario has [pendant] and [serial] and outlives the session. `clock`: real time.
  explicit LiveSession(const Scenario& scenario, std::function<Clock::time_point()> clock = Clock::now);

  // For listeners, before the first advance().
  [[nodiscard]] Run& run() { return run_; }
  [[nodiscard]] const LivePendant& pendant() const { return pendant_; }
  [[nodiscard]] const LiveWatch& watch() const { return watch_; }
  [[nodiscard]] const LiveCell& cell() const { return cell_; }

  // Continues up to this cycle. False when the run is over.
  bool advance(Cycles until);
  // The message for the page. `factor`: simulated time per real time, lately.
  [[nodiscard]] std::string state(double factor);

  // WebApplication
  [[nodiscard]] std::string page() override;
  [[nodiscard]] std::string on_opened() override;
  void on_closed() override;
  [[nodiscard]] std::string on_message(std::string_view text) override;

 private:
  const Scenario& scenario_;
  std::function<Clock::time_point()> clock_;
  LiveWatch watch_;
  LivePendant pendant_;
  LiveKinematics kinematics_;
  Run run_;
  LiveCell cell_;
  PageCommands commands_;
  Clock::time_point last_message_{};
};

}  // namespace armature::cosim
