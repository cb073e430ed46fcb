// A live session with its past: it can be looked at as it was at any time, and go on from there as a new branch. Then
// what came after that time is gone, also in the files of the session, so that they always repeat the branch that is
// shown.
//
// The session lives in a process of its own, with return points (cosim/snapshot). This object keeps the messages of the
// page with their cycles. To show a moment the session returns to the latest point before it, and gets the messages
// from there to the moment again.
//
// It also decides by real time whether somebody is at the page.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "controller/base/units.hpp"
#include "cosim/live/past/kept_file.hpp"
#include "cosim/live/past/session_messages.hpp"
#include "cosim/live/web_server.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/snapshot/message_channel.hpp"

namespace armature::cosim {

// Paths of the files that the session writes; empty: it is not written.
struct SessionFiles {
  std::filesystem::path serial{}, log{};
};

struct SessionResult {
  Cycles cycles{};
  std::int64_t ticks = 0;
  std::string sha256;
  std::string failure;  // empty: none
  bool interrupted = false;
  std::vector<std::string> overrides;  // of LiveCell
};

class ReversibleSession final : public WebApplication {
 public:
  using Clock = std::chrono::steady_clock;
  // The page sends something every 100 ms. Without a message for this time nobody is there: the page is frozen, or
  // behind another window, where its operator could not see the arm. A closed page is noticed at once, and a jog ends
  // 150 ms after its last message.
  static constexpr std::chrono::milliseconds kPatience{1'000};

  // The scenario has [pendant] and [serial] and outlives the session. `clock`: real time. Throws std::runtime_error, as
  // the others, when the process cannot be made, has ended, or says that the run cannot continue; InputError when a
  // file cannot be written.
  explicit ReversibleSession(const Scenario& scenario, const SessionFiles& files = {},
                             std::function<Clock::time_point()> clock = Clock::now);
  ReversibleSession(const ReversibleSession&) = delete;
  ReversibleSession& operator=(const ReversibleSession&) = delete;
  ~ReversibleSession() override;

  [[nodiscard]] Cycles now() const { return now_; }
  // The past is shown. The session does not go on.
  [[nodiscard]] bool is_looking() const { return looking_; }
  // It is on the way to the moment that will be shown: each advance() goes a part of it.
  [[nodiscard]] bool is_on_the_way() const { return way_.has_value(); }
  // How often now() has jumped.
  [[nodiscard]] int jumps() const { return jumps_; }

  // Continues up to this cycle, if the past is not shown. False when the run is over.
  bool advance(Cycles until);
  // The message for the page: the state of LiveSession, and `bar`: {"end_s", "looking", "on_the_way", "jumps"}.
  [[nodiscard]] std::string state(double factor);
  // Ends the session where it is. Call it once.
  [[nodiscard]] SessionResult finish();

  // WebApplication. Besides the messages of PageCommands there are `look` with `t_s` and `live`.
  [[nodiscard]] std::string page() override;
  [[nodiscard]] std::string on_opened() override;
  void on_closed() override;
  [[nodiscard]] std::string on_message(std::string_view text) override;

 private:
  struct Told {
    Cycles at{};
    std::string message;  // empty: nobody is at the page any more
  };

  std::string ask(const SessionRequest& request, std::string_view text = {});
  std::string tell(std::string message);
  std::string repeat(const Told& told);
  std::string act(std::string_view text);
  void look(double t_s);
  void go_live();
  void follow_way();
  void leave();
  [[nodiscard]] bool has_operator() const { return next_ > 0 && !told_[next_ - 1].message.empty(); }

  const Scenario& scenario_;
  std::function<Clock::time_point()> clock_;
  KeptFile serial_, log_;
  MessageChannel channel_;
  pid_t process_ = 0;
  std::vector<Told> told_;  // of this branch, in the order of time
  std::size_t next_ = 0;    // so many of them belong to the past of now()
  Cycles now_{}, end_{};    // end of the branch
  Cycles written_{};        // when the files were written through
  bool over_ = false;
  bool looking_ = false;
  std::optional<Cycles> way_;  // its end; only while looking
  bool then_live_ = false;     // at the end of the way it goes on
  int jumps_ = 0;
  Clock::time_point last_message_{};
};

}  // namespace armature::cosim
