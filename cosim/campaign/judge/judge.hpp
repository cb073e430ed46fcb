// Judges a run of a campaign by what the motors, the pins and the servo power truly did.
//
// Of the controller it hears the faults that it reports and the moves that it refuses. It asks whether the arm is where
// the run without faults brought it, within the limits of the robot file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "controller/base/units.hpp"
#include "cosim/campaign/judge/judge_limits.hpp"
#include "cosim/campaign/judge/outcome.hpp"
#include "cosim/campaign/judge/true_path.hpp"
#include "cosim/run/run_listener.hpp"

namespace armature::cosim {

class CampaignJudge final : public RunListener {
 public:
  // `path` is that of the run without faults, and must outlive the judge. `faults_end`: when the last fault is over.
  CampaignJudge(const JudgeLimits& limits, const TruePath& path, Cycles faults_end)
      : limits_{limits}, path_{path}, faults_end_{faults_end} {}

  void on_row(const TraceRow& row, const IntegerDigest&) override;
  void on_event(const Event& event, const RunPlace& place) override;
  void on_action(const ScriptAction& action, const RunPlace& place) override;
  void on_signal(const Signal& signal, const RunPlace& place) override;

  // Nothing more can happen: the arm has been at the end of its path, or without power, for some time.
  [[nodiscard]] bool may_end() const;

  // The first response, if it came after the begin of a fault.
  [[nodiscard]] std::optional<Cycles> detected() const;

  // After the run. `failure`: why it was broken off.
  [[nodiscard]] Verdict verdict(const std::optional<std::string>& failure) const;

 private:
  struct Error {
    Outcome outcome;
    std::string reason;
  };
  struct Begun {
    Cycles at{};
    int axis = 0;  // 0: of no single axis
  };
  struct Reported {
    FaultCause cause = FaultCause::kNone;
    int axis = 0;
    Cycles at{};
  };

  void detect(Cycles at);
  void add(Outcome outcome, std::string reason);
  void see_power(std::uint8_t levels, Cycles at);
  void compare(const TruePoint& now);
  void check_path(const TruePoint& now);
  void check_speed(const TruePoint& now);
  void check_range(const TruePoint& now);
  void check_without_power(const TruePoint& now, bool pushed);
  [[nodiscard]] bool is_strong_push(const FaultKind& kind) const;
  [[nodiscard]] bool is_pushed(Cycles now);
  [[nodiscard]] bool near_path(const TruePoint& now) const;
  [[nodiscard]] bool is_end(const PerAxis<std::int64_t>& counts) const;
  [[nodiscard]] std::optional<Error> power_error() const;
  [[nodiscard]] std::optional<Error> blame_error() const;
  [[nodiscard]] std::optional<Error> end_error() const;
  [[nodiscard]] std::optional<Error> error() const;
  [[nodiscard]] std::string stop_reason() const;

  static constexpr std::size_t kSpeedTicks = 100;  // rows over which the speed is measured

  const JudgeLimits& limits_;
  const TruePath& path_;
  Cycles faults_end_;
  std::size_t rows_ = 0;
  TruePoint last_;
  PerAxis<std::int64_t> known_counts_{};  // by the controller, at the last row
  std::array<TruePoint, kSpeedTicks> before_{};
  std::size_t rest_rows_ = 0;    // since the motors stand
  std::size_t at_end_rows_ = 0;  // since the arm is at the end of its path
  std::size_t off_rows_ = 0;     // since all servo power is away
  bool identical_ = true;
  std::uint8_t servo_on_ = 0;
  bool was_on_ = false;
  std::optional<Cycles> power_off_;  // all of it, after it was on
  std::optional<TruePoint> at_power_off_;
  std::optional<Cycles> push_end_;  // of a strong push; none: there was no one, or the arm has rested since
  bool was_pushed_ = false;         // strongly
  std::optional<Cycles> estop_;     // demanded
  std::vector<Begun> begun_;
  std::vector<Reported> reported_;
  std::int64_t refusals_ = 0;
  bool program_failed_ = false;
  std::optional<Cycles> detected_;
  std::uint32_t underruns_ = 0;
  std::optional<Error> first_error_;  // the gravest that was seen while the run went on
};

}  // namespace armature::cosim
