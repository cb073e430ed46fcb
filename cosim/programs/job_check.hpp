// Checks the texts of the jobs of a robot program before a run.
#pragma once

#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "controller/language/job/loader/loader.hpp"
#include "controller/language/job/memory/program_memory.hpp"
#include "controller/language/text/diagnostics.hpp"
#include "cosim/programs/program_spec.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {

class JobCheck {
 public:
  void load(const ProgramFile& file);
  // The jobs that are called, are not loaded, and were not returned before.
  [[nodiscard]] std::vector<std::string> new_missing_jobs();
  // After all files: compares the jobs with each other, and adds all errors to `all`.
  void finish(std::vector<Problem>& all);

 private:
  class Problems final : public Diagnostics {
   public:
    void report(const Diagnostic& diagnostic) noexcept override;
    std::vector<Problem> all;
  };

  Problems problems_;
  std::unique_ptr<job::ProgramMemory> memory_ = std::make_unique<job::ProgramMemory>();
  std::unique_ptr<job::Loader> loader_ = std::make_unique<job::Loader>(*memory_, problems_);
  std::size_t records_ = 0;  // that were searched for calls
  std::set<std::string> asked_for_;
  bool accepted_ = true;
};

}  // namespace armature::cosim
