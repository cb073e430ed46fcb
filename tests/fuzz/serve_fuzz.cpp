// Any bytes from a client of `armature serve`: each line gets one answer of printable ASCII, and the logic continues.
// The session lives as long as the process, as that of a client does.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "cosim/net/line_buffer.hpp"
#include "tests/cosim/support/serve_session.hpp"

namespace {

bool is_answer(std::string_view text) {
  using armature::cosim::Interpreter;
  if (text.size() > Interpreter::kMaxBatchAnswer || !text.ends_with('\n')) return false;
  text.remove_suffix(1);
  if (text != "ok" && !text.starts_with("ok ") && !text.starts_with("error ")) return false;
  return std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace armature::cosim;
  // Every run of the logic ends after a few thousand cycles.
  static test::ServeSession session{make_verilated_fabric(), [] { return true; }};
  LineBuffer lines{Interpreter::kMaxBatchLine};
  lines.append({reinterpret_cast<const char*>(data), size});
  lines.append("\n");
  while (const auto line = lines.next()) {
    std::string answer;
    if (line->too_long) {
      session.interpreter.answer_to_long_line(answer);
    } else {
      session.interpreter.answer(line->text, answer, session.stop);
    }
    if (!is_answer(answer) || session.interpreter.broken()) std::abort();
  }
  return 0;
}
