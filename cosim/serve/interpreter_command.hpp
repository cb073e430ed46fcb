// An entry in the list of commands.
#pragma once

#include <string>
#include <string_view>

#include "cosim/serve/interpreter.hpp"

namespace armature::cosim {

struct Interpreter::Command {
  std::string_view name;
  std::string_view usage;
  std::string_view what;
  void (Interpreter::*execute)(CommandWords& words, std::string& out);
  bool in_batch = false;  // it may be an operation of a batch
};

}  // namespace armature::cosim
