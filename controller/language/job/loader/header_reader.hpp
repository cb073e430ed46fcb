// Reads what stands above the instructions of a job: name, positions, attributes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "controller/language/job/memory/program_memory.hpp"
#include "controller/language/text/diagnostics.hpp"

namespace armature::job {

// The diagnostics of one file, with the number of its line.
struct FileDiagnostics {
  Diagnostics& out;
  std::string_view name{};
  std::uint32_t line = 0;
  std::size_t errors = 0;

  void error(std::size_t column, const DiagnosticText& text) noexcept {
    report(Diagnostic::Severity::kError, column, text);
  }
  void warn(std::size_t column, const DiagnosticText& text) noexcept {
    report(Diagnostic::Severity::kWarning, column, text);
  }
  void report(Diagnostic::Severity severity, std::size_t column, const DiagnosticText& text) noexcept {
    if (severity == Diagnostic::Severity::kError) ++errors;
    out.report({severity, name, line, static_cast<std::uint32_t>(column), text});
  }
};

class HeaderReader {
 public:
  // References must outlive the reader.
  HeaderReader(ProgramMemory& memory, FileDiagnostics& file) noexcept : memory_{memory}, file_{file} {}

  void begin(JobInfo& job) noexcept;
  // True once //INST was read: instructions follow when a line does not begin with a slash.
  [[nodiscard]] bool in_instructions() const noexcept { return section_ == Section::kInst; }
  // A line of the header. False: it is an instruction.
  [[nodiscard]] bool read(std::string_view line) noexcept;
  // Reports what is missing, and wrong counts.
  void finish() noexcept;

 private:
  enum class Section : std::uint8_t { kNothing, kJob, kPos, kArguments, kInst };

  void keep(std::string_view line) noexcept;
  void read_pseudo(std::string_view name, std::string_view value, std::size_t column) noexcept;
  void read_name(std::string_view value, std::size_t column) noexcept;
  void read_position(std::string_view line) noexcept;
  void read_postype(std::string_view value, std::size_t column) noexcept;
  void read_rconf(std::string_view value, std::size_t column) noexcept;
  void enter(Section section, std::string_view name) noexcept;
  // Up to `most` whole numbers between commas; -1 after an error.
  [[nodiscard]] int read_numbers(std::string_view value, std::size_t column, std::size_t most,
                                 std::array<std::int64_t, 32>& numbers) noexcept;
  [[nodiscard]] std::int64_t read_one(std::string_view value, std::size_t column, std::int64_t most) noexcept;

  ProgramMemory& memory_;
  FileDiagnostics& file_;
  JobInfo* job_ = nullptr;
  Section section_ = Section::kNothing;
  bool has_name_ = false;
  Position modal_{};  // what the lines above say about the next positions
  std::uint32_t npos_line_ = 0;
  std::array<std::int64_t, 6> npos_{};  // as stated
  std::array<std::int64_t, 6> counted_{};
};

}  // namespace armature::job
