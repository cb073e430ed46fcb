#include "cosim/run/event_log.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <string_view>
#include <variant>

#include "controller/base/angle_units.hpp"
#include "cosim/report/format/program_note_text.hpp"
#include "cosim/report/format/refusal_text.hpp"
#include "cosim/report/measure/run_facts.hpp"
#include "cosim/text/names.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

std::string axis_suffix(int axis) {
  return axis == 0 ? std::string{} : fmt::format(", axis {}", axis);
}

}  // namespace

std::string stamp(Cycles now) {
  return fmt::format("[{:.6f} s]", to_seconds(now));
}

void EventLog::write(const Event& event, Cycles now) {
  std::visit([&](const auto& happened) { log(happened, now); }, event);
}

void EventLog::log(const MoveStarted& move, Cycles) {
  const double off_deg = move.residual_rad * kDegPerRad;
  log_.info("{} {} starts after tick {}, takes {} ticks{}{}{}{}", names_.of(move.tag), move_name(move),
            move.start_tick.value(), move.duration.value(),
            off_deg > kNoDeviationDeg ? fmt::format(", orientation missed by up to {:.4g} deg", off_deg) : "",
            move.stretch > 1
                ? fmt::format(", stretched {:.3f} times for {}", move.stretch, mover_name(move.stretched_for))
                : std::string{},
            move.continues ? ", blended with the move before" : "",
            move.unasked_stop ? ", after a stop that nobody asked for" : "");
}

void EventLog::log(const MoveRefused& refusal, Cycles now) {
  log_.warn("{} {} {}: {}", stamp(now), names_.of(refusal.tag), refusal_word(refusal.reason), refusal_text(refusal));
}

void EventLog::log(const IoDone& done, Cycles now) {
  log_.info("{} {} pin {} = {}", stamp(now), names_.of(done.tag), done.pin, done.level ? 1 : 0);
}

void EventLog::log(const JogStarted& jog, Cycles) {
  log_.info("{} jog starts after tick {}", names_.of(jog.tag), jog.tick.value());
}

void EventLog::log(const JogEnded& jog, Cycles now) {
  log_.info("{} {} jog of {} ticks with {} commands ended by {}", stamp(now), names_.of(jog.tag), jog.taken.value(),
            jog.commands, jog_end_text(jog.how, jog.axis));
}

void EventLog::log(const HomingStarted& axis, Cycles) {
  log_.info("{} homing of axis {} starts after tick {}", names_.of(axis.tag), axis.axis, axis.tick.value());
}

void EventLog::log(const HomingEnded& axis, Cycles now) {
  log_.info("{} {} homing of axis {} {}", stamp(now), names_.of(axis.tag), axis.axis, homing_text(axis));
}

void EventLog::log(const Faulted& fault, Cycles now) {
  log_.error("{} fault: {}{}", stamp(now), word_of(fault.cause), axis_suffix(fault.axis));
}

void EventLog::log(const StreamEnded& stream, Cycles now) {
  log_.info("{} {} ended: {}, followed for {} ticks", stamp(now), names_.of(stream.tag), word_of(stream.how),
            stream.followed);
}

void EventLog::log(const PartFollowed& part, Cycles now) {
  static constexpr std::array<std::string_view, 5> kPhases{"the arm begins to follow it", "synchronised",
                                                           "the arm leaves it", "ended", "missed"};
  const bool ended = part.phase == PartPhase::kEnded;
  log_.info("{} part[{}] at {:.2f} mm: {}{}", stamp(now), part.part, part.displacement_mm,
            kPhases[static_cast<std::size_t>(part.phase)],
            ended ? fmt::format(" ({}{}), largest deviation of the frame {:.4f} mm", word_of(part.end),
                                axis_suffix(part.axis), part.deviation_mm)
                  : std::string{});
  if (!ended || part.corrected + part.out_of_range + part.no_result == 0) return;
  log_.info("{} part[{}]: a network corrected {} ticks; in {} the belt was outside its ranges, in {} it had no result",
            stamp(now), part.part, part.corrected, part.out_of_range, part.no_result);
}

void EventLog::log(const ProgramNoted& note, Cycles now) {
  using enum ProgramNoted::Kind;
  const bool failed = note.kind == kAlarm || note.kind == kStopped;
  log_.log(failed ? spdlog::level::err : spdlog::level::info, "{} {} {}", stamp(now), names_.line_text(note.place),
           program_note_text(note));
}

void EventLog::log(const OutputSwitched& output, Cycles) {
  log_.info("{} switches pin {} = {} in tick {}", names_.of(output.tag), output.pin, output.level ? 1 : 0,
            output.tick.value());
}

}  // namespace armature::cosim
