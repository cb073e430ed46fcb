// Programs as texts, and what a loader says about them.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "controller/language/job/loader/loader.hpp"
#include "controller/language/job/loader/printer.hpp"
#include "controller/language/job/memory/program_memory.hpp"

namespace armature::test {

class CollectedDiagnostics final : public Diagnostics {
 public:
  void report(const Diagnostic& diagnostic) noexcept override {
    const bool error = diagnostic.severity == Diagnostic::Severity::kError;
    (error ? errors : warnings)
        .push_back(std::string{diagnostic.file} + ":" + std::to_string(diagnostic.line) + ":" +
                   std::to_string(diagnostic.column) + ": " + std::string{diagnostic.text.view()});
  }
  std::vector<std::string> errors, warnings;
};

class CollectedText final : public TextSink {
 public:
  void write(std::string_view piece) noexcept override { text += piece; }
  std::string text;
};

// A program memory with its loader.
struct Jobs {
  std::unique_ptr<job::ProgramMemory> memory = std::make_unique<job::ProgramMemory>();
  CollectedDiagnostics said;
  std::unique_ptr<job::Loader> loader = std::make_unique<job::Loader>(*memory, said);

  bool load(const std::string& text, const std::string& file = "a.jbi") { return loader->load(file, text); }
  [[nodiscard]] std::string printed(std::size_t job = 0) const {
    CollectedText out;
    print_job(*memory, memory->jobs[job], out);
    return out.text;
  }
};

// All errors of a file.
inline std::vector<std::string> errors_of(const std::string& text) {
  Jobs jobs;
  const bool loaded = jobs.load(text);
  EXPECT_EQ(loaded, jobs.said.errors.empty());
  return jobs.said.errors;
}

// A job with these instructions between NOP, which is line 6, and END.
inline std::string job_of(const std::string& instructions, const std::string& name = "TEST") {
  return "/JOB\n//NAME " + name + "\n//POS\n///NPOS 0,0,0,0,0,0\n//INST\nNOP\n" + instructions + "END\n";
}

// The same with positions C0 to C4 before them; NOP is line 14.
inline std::string moving_job_of(const std::string& instructions, const std::string& name = "TEST") {
  return "/JOB\n//NAME " + name +
         "\n//POS\n///NPOS 5,0,0,0,0,0\n///TOOL 0\n///POSTYPE PULSE\n///PULSE\n"
         "C00000=0,0,0,0,0,0\nC00001=1000,0,0,0,0,0\nC00002=1000,1000,0,0,0,0\nC00003=0,1000,0,0,0,0\n"
         "C00004=0,0,1000,0,0,0\n//INST\nNOP\n" +
         instructions + "END\n";
}

// The same lines with the ends that the printer writes.
inline std::string with_controller_ends(const std::string& text) {
  std::string result;
  for (const char character : text) result += character == '\n' ? std::string{"\r\n"} : std::string{character};
  return result;
}

}  // namespace armature::test
