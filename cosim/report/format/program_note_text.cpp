#include "cosim/report/format/program_note_text.hpp"

#include "cosim/text/names.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {

std::string program_note_text(const ProgramNoted& note) {
  using enum ProgramNoted::Kind;
  std::string text{note.kind == kLine ? "interpreted" : program_note_name(note.kind)};
  if (note.text_size == 0) return text;
  const std::string quote = note.kind == kMessage ? "\"" : "";
  return text.append(": ").append(quote).append(printable(note.view())).append(quote);
}

}  // namespace armature::cosim
