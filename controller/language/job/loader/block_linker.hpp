// Connects the instructions of a job with each other: labels, blocks, runs of arc points, and positions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "controller/language/job/loader/header_reader.hpp"
#include "controller/language/job/memory/program_memory.hpp"

namespace armature::job {

class BlockLinker {
 public:
  static constexpr std::size_t kDeepestBlock = 32;

  // References must outlive the linker.
  BlockLinker(ProgramMemory& memory, const JobInfo& job, FileDiagnostics& file) noexcept
      : memory_{memory}, job_{job}, file_{file} {}

  void link() noexcept;

 private:
  // An open block: its first instruction, and the last one that waits for its target.
  struct Block {
    std::uint16_t start = 0;
    std::uint16_t last = 0;
    bool has_default = false;  // ELSE or DEFAULT was there
  };

  void check_ends() noexcept;
  void link_labels() noexcept;
  void link_label(std::uint16_t at, std::size_t operand) noexcept;
  void link_positions() noexcept;
  void link_blocks() noexcept;
  void open(std::uint16_t at) noexcept;
  void branch(std::uint16_t at) noexcept;
  void close(std::uint16_t at) noexcept;
  void close_if_or_switch(const Block& block, std::uint16_t end) noexcept;
  void link_runs() noexcept;
  void too_few_points(std::uint16_t at) noexcept;
  void end_run(std::uint16_t first, std::uint16_t last) noexcept;

  [[nodiscard]] Record& record(std::uint16_t at) noexcept { return memory_.records[job_.first_record + at]; }
  // Report at the instruction, and at one of its operands.
  void error(std::uint16_t at, const DiagnosticText& text) noexcept;
  void error_at(std::uint16_t at, std::size_t operand, const DiagnosticText& text) noexcept;

  ProgramMemory& memory_;
  const JobInfo& job_;
  FileDiagnostics& file_;
  std::array<Block, kDeepestBlock> blocks_{};
  std::size_t depth_ = 0;
};

}  // namespace armature::job
