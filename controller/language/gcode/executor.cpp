#include "controller/language/gcode/executor.hpp"

#include <cmath>

#include "controller/base/rounding.hpp"

namespace armature::gcode {
namespace {

// Where a line has M66 the program waits; M0, M1, M60: it pauses; M2, M30: it ends.
bool ends(const CodeInfo& code) noexcept {
  return code.tenths == 20 || code.tenths == 300;
}

}  // namespace

void Executor::begin_program(const Axes6& machine) noexcept {
  line_ = 0;
  modes_ = Modes{};
  cycle_.abort();
  memory_ = {};
  after_ = After::kNext;
  returned_.reset();
  call_level_ = 0;
  saved_.front().valid = false;
  parameters_.begin_program();
  if (parameters_.at(kSystemParameter) == 0.0) parameters_.at(kSystemParameter) = 1.0;
  offsets_ = Offsets{};
  offsets_ = with_system(static_cast<int>(parameters_.at(kSystemParameter)));
  if (parameters_.at(kG92ActiveParameter) != 0.0) offsets_.g92 = stored(kG92Parameter);
  place_ = offsets_.place(machine);
  emit(UseLengthUnits{});
  emit(SetG5xOffset{.index = static_cast<int>(parameters_.at(kSystemParameter)), .offset = offsets_.g5x});
  emit(SetG92Offset{offsets_.g92});
  emit(SetXyRotation{offsets_.rotation_deg});
}

Executor::Failure Executor::execute(Block& block, std::uint32_t line) noexcept {
  line_ = line;
  after_ = After::kNext;
  if (const Failure failure = set_polar(block.words, block)) return failure;
  if (const Failure failure = check_block(block, modes_.motion)) return failure;
  if (const Failure failure = set_feed(block)) return failure;
  if (const Failure failure = set_spindle_and_tool(block)) return failure;
  if (const Failure failure = use_saved_state(block)) return failure;
  set_coolant(block);
  if (const Failure failure = set_overrides(block)) return failure;
  if (block.is(Group::kOnce, 40)) {
    if (!block.words.has('p')) return error_of(ErrorCode::kWordMissing, 'p');
    if (block.words.get('p') < 0.0) return error_of(ErrorCode::kWordNegative, 'p');
    emit(Dwell{block.words.get('p')});
  }
  set_units_and_plane(block);
  if (const Failure failure = set_tool_offset(block)) return failure;
  set_system(block);
  if (const Failure failure = set_control(block)) return failure;
  if (const Failure failure = execute_once(block)) return failure;
  if (const Failure failure = move(block)) return failure;
  if (const CodeInfo* code = block.code(Group::kStop)) {
    if (ends(*code)) {
      end_program(code->tenths == 300);
      after_ = After::kEnd;
    } else {
      stop(code);
      after_ = After::kStop;
    }
  }
  return std::nullopt;
}

void Executor::save(Stored& stored) const noexcept {
  for (std::size_t i = 0; i < stored.parameters.size(); ++i) {
    stored.parameters[i] = parameters_.at(kFirstStored + static_cast<int>(i));
  }
  stored.tools = tools_;
}

void Executor::restore(const Stored& stored) noexcept {
  for (std::size_t i = 0; i < stored.parameters.size(); ++i) {
    parameters_.at(kFirstStored + static_cast<int>(i)) = stored.parameters[i];
  }
  tools_ = stored.tools;
}

void Executor::end(std::uint32_t line) noexcept {
  line_ = line;
  end_program(false);
}

void Executor::continue_cycle() noexcept {
  cycle_.step(sink_);
  place_ = cycle_.place();
}

void Executor::say(Text::Kind kind, std::string_view text, std::uint32_t line) noexcept {
  line_ = line;
  emit(Text{.kind = kind, .text = text});
}

Executor::Failure Executor::whole(const Words& words, char letter, int least, int most, int& value) const noexcept {
  if (!words.has(letter)) return error_of(ErrorCode::kWordMissing, letter);
  const double given = words.get(letter);
  if (given < least - 0.5 || given > most + 0.5) return error_of(ErrorCode::kWordRange, letter);
  const auto nearest = static_cast<int>(round_half_away(given));
  if (std::fabs(given - nearest) > kEqual) return error_of(ErrorCode::kNotAnInteger, letter);
  value = nearest;
  return std::nullopt;
}

}  // namespace armature::gcode
