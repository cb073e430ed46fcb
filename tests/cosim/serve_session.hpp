// A served logic and its interpreter, for tests of the protocol without a socket.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "cosim/fabric/verilated_fabric.hpp"
#include "cosim/serve/interpreter.hpp"
#include "cosim/serve/served_soc.hpp"

namespace armature::cosim::test {

struct ServeSession {
  explicit ServeSession(
      std::unique_ptr<Fabric> fabric = make_verilated_fabric(), StopRequest stop_ = [] { return false; })
      : soc{std::move(fabric)}, stop{std::move(stop_)} {}

  // The answer without its end.
  std::string operator()(std::string_view line) {
    std::string answer;
    interpreter.answer(line, answer, stop);
    if (!answer.ends_with('\n')) return "no end of line: " + answer;
    answer.pop_back();
    return answer;
  }

  ServedSoc soc;
  Interpreter interpreter{soc};
  StopRequest stop;  // asked during long runs
};

}  // namespace armature::cosim::test
