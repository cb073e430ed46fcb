// The command `batch`: many operations in one line, one answer to all of them.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "cosim/serve/interpreter.hpp"
#include "cosim/serve/interpreter_command.hpp"

namespace armature::cosim {
namespace {

constexpr char kBetween = ';';
constexpr std::string_view kOk = "ok";
constexpr std::string_view kNoValue = " -";

}  // namespace

void Interpreter::batch(CommandWords& words, std::string& out) {
  std::string_view left = words.rest();
  const auto operations = static_cast<std::size_t>(std::ranges::count(left, kBetween)) + 1;
  if (operations > kMaxOperations) {
    throw CommandRefused{fmt::format("a batch has at most {} operations, found {}", kMaxOperations, operations)};
  }
  out += kOk;
  const std::size_t values = out.size();
  Cycles asked = soc_.now();
  for (std::size_t i = 0; i < operations; ++i) {
    const std::string_view text = left.substr(0, left.find(kBetween));
    left.remove_prefix(std::min(text.size() + 1, left.size()));
    const std::size_t value = out.size();
    try {
      if (soc_.now() - asked >= ServedSoc::kStopCycles) {
        asked = soc_.now();
        if ((*stop_)()) throw CommandRefused{fmt::format("interrupted at cycle {}", asked.value())};
      }
      execute_operation(text, out);
    } catch (const CommandRefused& refused) {
      const std::string executed = i == 0 ? "none" : fmt::format("0..{}:{}", i - 1, out.substr(values, value - values));
      throw CommandRefused{fmt::format("operation {} of {}: {}; executed {}", i, operations, refused.what(), executed)};
    }
  }
}

// Appends its value, or `-`, after a blank.
void Interpreter::execute_operation(std::string_view text, std::string& out) {
  CommandWords first{text, "help batch"};
  if (first.empty()) throw CommandRefused{"an operation is missing"};
  const std::string_view name = first.word("operation");
  const Command* command = find(name);
  if (command == nullptr || !command->in_batch) {
    throw CommandRefused{
        fmt::format("{} cannot be in a batch; r, w, run, run-until-irq, pin, time can", in_quotes(name))};
  }
  CommandWords words{first.rest(), command->usage};
  const std::size_t begin = out.size();
  (this->*command->execute)(words, out);
  out.erase(begin, kOk.size());
  if (out.size() == begin) out += kNoValue;
}

}  // namespace armature::cosim
