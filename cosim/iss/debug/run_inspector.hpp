// Shows and changes a run that stands: registers, memory, registers of the logic, the answers of `monitor`.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "cosim/iss/arm_program.hpp"
#include "cosim/iss/debug/run_messages.hpp"
#include "cosim/run/run.hpp"

namespace armature::cosim::iss {

class RunInspector {
 public:
  // Where the run stands.
  struct Standing {
    const ArmCore* core = nullptr;             // that is about to execute an instruction
    std::array<std::uint32_t, 2> addresses{};  // of the latest instruction of each core
  };
  // `wave`: as of DebuggedRunOptions. All must outlive this.
  RunInspector(const Scenario& scenario, Run& run, ArmProgram& program,
               const std::optional<std::filesystem::path>& wave)
      : scenario_{scenario}, run_{run}, program_{program}, wave_{wave} {}

  // Of a request that neither continues the run nor takes it back.
  [[nodiscard]] DebugAnswer answer(const DebugRequest& request, const Standing& at);

  // Whether registers or memory were written since the last call.
  [[nodiscard]] bool take_written() { return std::exchange(written_, false); }
  // Whether the core that stands has got another pc since the last call.
  [[nodiscard]] bool take_jump() { return std::exchange(jumps_, false); }

  [[nodiscard]] bool wave_is_on() const { return wave_is_on_; }
  void close_wave();

 private:
  [[nodiscard]] bool is_between(const ArmCore& core) const;
  [[nodiscard]] DebugAnswer registers(int number);
  [[nodiscard]] DebugAnswer write_register(const DebugRequest& request);
  [[nodiscard]] DebugAnswer read(const DebugRequest& request);
  void read_logic(const DebugRequest& request, DebugAnswer& answer);
  [[nodiscard]] DebugAnswer write(const DebugRequest& request);
  [[nodiscard]] std::string state(const ArmCore& core) const;
  [[nodiscard]] DebugAnswer monitor(const std::string& command);
  std::string wave_on();
  std::string wave_off();

  const Scenario& scenario_;
  Run& run_;
  ArmProgram& program_;
  const std::optional<std::filesystem::path>& wave_;
  Standing at_;
  bool written_ = false;
  bool jumps_ = false;
  bool wave_is_on_ = false;
};

}  // namespace armature::cosim::iss
