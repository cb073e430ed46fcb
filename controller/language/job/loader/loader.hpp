// Reads job files into the program memory. All errors of a file are reported in one run.
//
// A file that has an error leaves the memory as it was. Jobs may call each other, so link() resolves the calls after
// all files are loaded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "controller/language/job/loader/header_reader.hpp"
#include "controller/language/job/loader/line_lexer.hpp"
#include "controller/language/job/memory/program_memory.hpp"
#include "controller/language/text/diagnostics.hpp"

namespace armature::job {

class Loader {
 public:
  // References must outlive the loader.
  Loader(ProgramMemory& memory, Diagnostics& diagnostics) noexcept : memory_{memory}, diagnostics_{diagnostics} {}

  // Loads one job. `file` is its name in messages. Lines end with CR LF, LF or CR. True if it has no error.
  [[nodiscard]] bool load(std::string_view file, std::string_view text) noexcept;
  // The last load() found no room for the whole file.
  [[nodiscard]] bool full() const noexcept { return full_; }
  // Resolves JOB:NAME of all jobs, and compares the position variables that they define. True if all are there.
  [[nodiscard]] bool link() noexcept;

 private:
  void read_line(std::string_view line) noexcept;
  void read_instruction(std::string_view line) noexcept;
  void add_record(Op op, std::string_view line, std::size_t indent, const LexedLine& lexed) noexcept;
  void finish_job() noexcept;
  void error(std::size_t column, const DiagnosticText& text) noexcept;
  void compare_position_variables() noexcept;

  ProgramMemory& memory_;
  Diagnostics& diagnostics_;
  FileDiagnostics file_{diagnostics_};
  HeaderReader header_{memory_, file_};
  JobInfo job_{};
  LexedLine lexed_{};
  bool full_ = false;  // a pool is full; the rest of the file is not encoded
};

}  // namespace armature::job
