#include "cosim/cli/waves/moment_wave.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <string_view>
#include <utility>

#include "cosim/report/format/progress_bar.hpp"
#include "cosim/run/progress_listener.hpp"
#include "cosim/serial/serial_log.hpp"
#include "cosim/serial/silent_peer.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

std::string_view what_was_not(WaveReason reason) {
  switch (reason) {
    case WaveReason::kFault:
      return "the controller reported no fault";
    case WaveReason::kFail:
      return "no expectation failed";
    case WaveReason::kMismatch:
      break;
  }
  return "no row of the run differs from the golden";
}

MomentWaveResult no_wave(const WaveOutput& output, std::string why) {
  return {.file = output.file.string(), .why_not = std::move(why)};
}

Cycles run_again(const MomentWaveRequest& request, const EndedRun& first, const WaveSpan& span) {
  Scenario scenario = first.scenario;
  if (scenario.engine == Engine::kModel) scenario.engine = Engine::kRtl;
  SilentPeer nobody;
  if (first.heard) {
    scenario.serial_sends =
        parse_serial_log(*first.heard, read_text_file(*first.heard, kMaxTableBytes), *scenario.serial);
  }
  Run run{scenario, {.serial_peer = first.heard ? &nobody : nullptr}};
  std::optional<ProgressListener> progress;
  if (first.show_progress && stderr_is_terminal()) run.add(progress.emplace(scenario, std::cerr));
  return write_span(run, span, request.output, first.stop_requested);
}

}  // namespace

MomentWaveResult write_moment_wave(const MomentWaveRequest& request, const EndedRun& run) {
  const auto& [wanted, output] = request;
  const bool ordered = run.snapshots != nullptr && run.snapshots->ordered();
  const std::optional<WaveMoment> moment = ordered ? run.snapshots->ordered() : shown_moment(wanted, run.summary);
  if (!moment) {
    const bool limited = wanted.from || wanted.to;
    return no_wave(output, fmt::format("{}{}", what_was_not(wanted.reason), limited ? " in this time" : ""));
  }
  WaveSpan span = span_of(wanted, *moment);
  std::optional<Cycles> end;
  if (run.snapshots != nullptr) end = run.snapshots->write(*moment);
  if (!end && run.stop_requested()) return no_wave(output, "the run was interrupted");
  span.to = end ? *end : run_again(request, run, span);
  if (span.to < span.from) return no_wave(output, "it was interrupted");
  return {.file = output.file.string(), .moment = moment->what, .at = moment->to, .from = span.from, .to = span.to};
}

}  // namespace armature::cosim
