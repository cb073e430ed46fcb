#include "cosim/exports/event_messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include "cosim/exports/mcap_channels.hpp"
#include "cosim/exports/run_times.hpp"
#include "cosim/text/csv_line.hpp"
#include "cosim/text/json.hpp"

namespace armature::cosim {
namespace {

// foxglove.Log
enum LogLevel : int { kInfo = 2, kWarning = 3, kError = 4 };

struct ProgramPlace {
  std::string file{};
  std::int64_t line = 0;
};

// Of a command such as "line 12 of part.ngc".
std::optional<ProgramPlace> program_place(std::string_view command) {
  constexpr std::string_view kLine = "line ", kOf = " of ";
  if (!command.starts_with(kLine)) return std::nullopt;
  command.remove_prefix(kLine.size());
  ProgramPlace place;
  const auto [end, error] = std::from_chars(command.data(), command.data() + command.size(), place.line);
  command.remove_prefix(static_cast<std::size_t>(end - command.data()));
  if (error != std::errc{} || !command.starts_with(kOf)) return std::nullopt;
  place.file = command.substr(kOf.size());
  return place;
}

class EventMessages {
 public:
  EventMessages(const RunRecord& run, const std::vector<RecordedProgram>& programs) : run_{run}, times_{run.trace} {
    for (const RecordedProgram& program : programs) {
      std::vector<std::string>& lines = lines_.emplace_back(program.name, std::vector<std::string>{}).second;
      for (std::string_view rest = program.text; !rest.empty();) lines.emplace_back(pop_line(rest));
    }
  }

  std::vector<TimedMessage> all() {
    add_states();
    add_moves();
    add_program();
    add_faults();
    add_pins();
    std::ranges::stable_sort(messages_, {}, &TimedMessage::time_ns);
    return std::move(messages_);
  }

 private:
  void add(RunChannel channel, std::uint64_t at, const Json& values) {
    Json message = {{"timestamp", time_json(at)}};
    message.update(values);
    messages_.push_back({at, channel, compact_text(message)});
  }

  void log(std::uint64_t at, LogLevel level, const char* name, const std::string& text,
           const ProgramPlace& place = {}) {
    add(kRunEvents, at,
        {{"level", level}, {"message", text}, {"name", name}, {"file", place.file}, {"line", place.line}});
  }

  void add_line(RunChannel channel, std::uint64_t at, const ProgramPlace& place) {
    const auto file = std::ranges::find(lines_, place.file, &std::pair<std::string, std::vector<std::string>>::first);
    const auto index = static_cast<std::size_t>(place.line - 1);
    const bool known = file != lines_.end() && place.line > 0 && index < file->second.size();
    add(channel, at, {{"file", place.file}, {"line", place.line}, {"text", known ? file->second[index] : ""}});
  }

  void add_states() {
    for (const StateSpan& span : run_.trace.states) {
      add(kMotionState, times_.of_row(span.first_row), {{"state", span.state}});
    }
  }

  void add_moves() {
    for (const Json& move : list("moves")) {
      const auto command = move["command"].get<std::string>();
      const ProgramPlace place = program_place(command).value_or(ProgramPlace{});
      const std::uint64_t start = times_.of_tick(move["start_tick"].get<std::int64_t>());
      const std::string what = fmt::format("{}: {}", command, move["kind"].get<std::string>());
      log(start, kInfo, "move", what + " begins", place);
      if (place.line > 0) add_line(kArmLine, start, place);
      if (move["taken_ticks"].is_null()) continue;
      const auto end = move["start_tick"].get<std::int64_t>() + move["taken_ticks"].get<std::int64_t>();
      log(times_.of_tick(end), kInfo, "move", what + " has ended", place);
    }
    for (const Json& move : list("refused_moves")) {
      const auto command = move["command"].get<std::string>();
      log(at_cycle(move), kError, "move", fmt::format("{} is refused: {}", command, move.value("text", "")),
          program_place(command).value_or(ProgramPlace{}));
    }
  }

  void add_program() {
    for (const Json& event : list("program")) {
      const ProgramPlace place{event.value("file", ""), event.value("line", std::int64_t{0})};
      const std::string kind = event.value("kind", "");
      if (kind == "line") {
        add_line(kReadLine, at_cycle(event), place);
        continue;
      }
      const std::string text = event.value("text", "");
      const bool bad = kind == "alarm" || kind == "aborted";
      log(at_cycle(event), bad ? kError : kInfo, "program", text.empty() ? kind : fmt::format("{}: {}", kind, text),
          place);
    }
  }

  void add_faults() {
    for (const Json& fault : list("injected_faults")) {
      log(at_cycle(fault), kWarning, "injected", fault.value("text", fault.value("kind", "")));
    }
    for (const Json& fault : list("faults")) {
      const int axis = fault.value("axis", 0);
      log(at_cycle(fault), kError, "fault",
          fmt::format("fault {}{}", fault.value("cause", ""), axis > 0 ? fmt::format(" of axis {}", axis) : ""));
    }
  }

  void add_pins() {
    for (const auto& [key, name] : {std::pair{"outputs", "output"}, std::pair{"inputs", "input"}}) {
      for (const Json& pin : list(key)) {
        log(at_cycle(pin), kInfo, "pin",
            fmt::format("{} {} becomes {}", name, pin.value("pin", 0), pin.value("level", 0)));
      }
    }
  }

  [[nodiscard]] static std::uint64_t at_cycle(const Json& event) { return ns_of_cycle(event.value("cycle", 0L)); }

  // An older version, or a run that did not end, may not have it.
  [[nodiscard]] const Json& list(const char* key) const {
    static const Json kNone = Json::array();
    const auto found = run_.summary["result"].find(key);
    return found != run_.summary["result"].end() && found->is_array() ? *found : kNone;
  }

  const RunRecord& run_;
  RunTimes times_;
  std::vector<std::pair<std::string, std::vector<std::string>>> lines_;
  std::vector<TimedMessage> messages_;
};

}  // namespace

std::vector<TimedMessage> event_messages(const RunRecord& run, const std::vector<RecordedProgram>& programs) {
  return EventMessages{run, programs}.all();
}

}  // namespace armature::cosim
