#include "cosim/report/format/program_note_text.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "cosim/scenario/pin_spec.hpp"
#include "cosim/text/names.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {

namespace {

// ` for input 3`, ` for inputs 1, 2`; empty: for none.
std::string inputs_text(std::uint16_t inputs) {
  std::string pins;
  for (std::int64_t pin = 1; pin <= kToolPins; ++pin) {
    if ((inputs >> (pin - 1) & 1) != 0) pins.append(pins.empty() ? "" : ", ").append(std::to_string(pin));
  }
  if (pins.empty()) return pins;
  return (pins.find(',') == std::string::npos ? " for input " : " for inputs ") + pins;
}

}  // namespace

std::string program_note_text(const ProgramNoted& note) {
  using enum ProgramNoted::Kind;
  std::string text{note.kind == kLine ? "interpreted" : word_of(note.kind)};
  if (note.kind == kOver) return "program is over: nothing of it is under way";
  if (note.kind == kWaits || note.kind == kWaited) text += inputs_text(note.inputs);
  if (note.text_size == 0) return text;
  const std::string quote = note.kind == kMessage ? "\"" : "";
  return text.append(": ").append(quote).append(printable(note.view())).append(quote);
}

std::string early_end_text(std::string_view program_end) {
  if (program_end == word_of(ProgramNoted::Kind::kPaused)) {
    return "the run ends here: its program is paused and nobody lets it continue, see program_resumes_after_s and "
           "[pendant]";
  }
  return fmt::format("the run ends here: [expect] does not state program_end = \"{}\"", program_end);
}

}  // namespace armature::cosim
