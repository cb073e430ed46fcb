// Any bytes as a G-code program: it ends, or fails with a line of the program. Each step makes only a few calls.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "controller/language/gcode/canon_interpreter.hpp"

namespace {

using armature::gcode::CanonInterpreter;

class CountingSink final : public armature::gcode::CanonSink {
 public:
  void on_call(const armature::gcode::CanonCall&, std::uint32_t) noexcept override { ++calls; }
  std::size_t calls = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static CountingSink sink;
  static const auto interpreter = std::make_unique<CanonInterpreter>(sink);
  static const auto fresh = [] {
    auto stored = std::make_unique<armature::gcode::Executor::Stored>();
    interpreter->executor().add_tool(1, {});
    interpreter->executor().save(*stored);
    return stored;
  }();
  constexpr int kMostSteps = 3'000;                                           // of a program without an end
  const std::string_view program{reinterpret_cast<const char*>(data), size};  // NOLINT: bytes as text
  interpreter->executor().restore(*fresh);  // a finding must not depend on the programs before
  CanonInterpreter::State state = interpreter->begin(program, {});
  for (int i = 0; i < kMostSteps && state != CanonInterpreter::State::kEnded; ++i) {
    if (state == CanonInterpreter::State::kFailed) {
      if (interpreter->error().line == 0 || interpreter->error().line > size + 1) std::abort();
      break;
    }
    sink.calls = 0;
    interpreter->resume();
    interpreter->give_input(1.0);
    state = interpreter->step();
    if (sink.calls > CanonInterpreter::kMaxCallsPerStep) std::abort();
  }
  return 0;
}
