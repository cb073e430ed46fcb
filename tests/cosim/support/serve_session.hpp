// A served logic and its interpreter, for tests of the protocol without a socket.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "cosim/fabric/verilated_fabric.hpp"
#include "cosim/serve/interpreter.hpp"
#include "cosim/serve/served_soc.hpp"
#include "tests/support/pin_soc.hpp"

namespace armature::cosim::test {

struct ServeSession {
  explicit ServeSession(
      std::unique_ptr<Fabric> fabric = make_verilated_fabric(), StopRequest stop_ = [] { return false; },
      WaveFolder waves = {})
      : soc{pin_soc(std::move(fabric))}, interpreter{soc, std::move(waves)}, stop{std::move(stop_)} {}
  // For tests of waveforms.
  explicit ServeSession(const std::filesystem::path& out)
      : ServeSession{make_verilated_fabric(), [] { return false; }, WaveFolder{out}} {}

  // The answer without its end.
  std::string operator()(std::string_view line) {
    std::string answer;
    interpreter.answer(line, answer, stop);
    if (!answer.ends_with('\n')) return "no end of line: " + answer;
    answer.pop_back();
    return answer;
  }

  ServedSoc soc;
  Interpreter interpreter;
  StopRequest stop;  // asked during long runs
};

}  // namespace armature::cosim::test
