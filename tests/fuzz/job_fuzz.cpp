// Any bytes as a robot program: it is loaded, or refused with at least one error. What was loaded is printed as a
// program that loads and prints the same again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include "controller/language/job/loader/loader.hpp"
#include "controller/language/job/loader/printer.hpp"

namespace {

using armature::Diagnostic;
using armature::Diagnostics;
using armature::TextSink;
using armature::job::Loader;
using armature::job::ProgramMemory;

class Errors final : public Diagnostics {
 public:
  void report(const Diagnostic& diagnostic) noexcept override {
    if (diagnostic.text.view().empty()) std::abort();
    if (diagnostic.severity == Diagnostic::Severity::kError) ++count;
  }
  int count = 0;
};

class Text final : public TextSink {
 public:
  void write(std::string_view text) noexcept override { all += text; }
  std::string all;
};

// None if the program has an error.
std::unique_ptr<ProgramMemory> load(std::string_view text) {
  auto memory = std::make_unique<ProgramMemory>();
  Errors errors;
  const auto loader = std::make_unique<Loader>(*memory, errors);
  const bool good = loader->load("fuzzed", text);
  if (good != (errors.count == 0)) std::abort();
  if (!good) return nullptr;
  static_cast<void>(loader->link());  // calls of jobs that are not there are its errors
  return memory;
}

std::string printed(const ProgramMemory& memory) {
  Text text;
  for (std::size_t i = 0; i < memory.job_count; ++i) print_job(memory, memory.jobs[i], text);
  Text list;
  for (std::size_t i = 0; i < memory.job_count; ++i) list_job(memory, memory.jobs[i], list);
  return text.all;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto memory = load({reinterpret_cast<const char*>(data), size});
  if (memory == nullptr) return 0;
  const std::string text = printed(*memory);
  const auto again = load(text);
  if (again == nullptr || printed(*again) != text) std::abort();
  return 0;
}
