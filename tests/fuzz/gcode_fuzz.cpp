// Any bytes as a G-code program: it ends, or fails with a line of the program. Each step makes only a few calls, and no
// place or feed of a call is infinite or not a number.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <variant>

#include "controller/base/overloaded.hpp"
#include "controller/language/gcode/flow/canon_interpreter.hpp"

namespace {

using armature::gcode::CanonInterpreter;

namespace gcode = armature::gcode;

bool finite(const gcode::Axes6& axes) {
  return std::ranges::all_of(axes, [](double value) { return std::isfinite(value); });
}

class FiniteSink final : public gcode::CanonSink {
 public:
  void on_call(const gcode::CanonCall& call, std::uint32_t) noexcept override {
    ++calls;
    const armature::Overloaded is_finite{
        [](const gcode::StraightTraverse& move) { return finite(move.end); },
        [](const gcode::StraightFeed& move) { return finite(move.end); },
        [](const gcode::ArcFeed& arc) {
          return finite({arc.first_end, arc.second_end, arc.axis_end, arc.a, arc.b, arc.c}) &&
                 std::isfinite(arc.first_axis) && std::isfinite(arc.second_axis);
        },
        [](const gcode::SetFeedRate& feed) { return std::isfinite(feed.mm_min); }, [](const auto&) { return true; }};
    if (!std::visit(is_finite, call)) std::abort();
  }
  std::size_t calls = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static FiniteSink sink;
  static const auto interpreter = std::make_unique<CanonInterpreter>(sink);
  static const auto fresh = [] {
    auto stored = std::make_unique<armature::gcode::Executor::Stored>();
    interpreter->executor().tools().add(1, {});
    interpreter->executor().save(*stored);
    return stored;
  }();
  constexpr int kMaxSteps = 3'000;                                            // of a program without an end
  const std::string_view program{reinterpret_cast<const char*>(data), size};  // NOLINT: bytes as text
  interpreter->executor().restore(*fresh);  // a finding must not depend on the programs before
  CanonInterpreter::State state = interpreter->begin({.text = program}, {});
  for (int i = 0; i < kMaxSteps && state != CanonInterpreter::State::kEnded; ++i) {
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
