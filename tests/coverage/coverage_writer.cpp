// Linked into each coverage program. It sums the counts of all models that the tests create. At the end it writes them
// in the format of Verilator to the file in the environment variable COVERAGE.
#include <unistd.h>
#include <verilated_cov.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>

#include "tests/support/verilated_test.hpp"

namespace armature::test {
namespace {

class Counts {
 public:
  // Verilator can only write to a file, with one line `C 'point' count` per point.
  void add(VerilatedContext& context) {
    const std::string scratch = path_ + "." + std::to_string(getpid());
    context.coveragep()->write(scratch.c_str());
    std::ifstream file{scratch};
    for (std::string line; std::getline(file, line);) {
      const std::size_t blank = line.rfind(' ');
      if (line.starts_with("C ")) counts_[line.substr(0, blank)] += std::stoull(line.substr(blank + 1));
    }
    std::remove(scratch.c_str());
  }

  ~Counts() {
    std::ofstream file{path_};
    file << "# SystemC::Coverage-3\n";
    for (const auto& [point, count] : counts_) file << point << ' ' << count << '\n';
  }

 private:
  static std::string path() {
    const char* path = std::getenv("COVERAGE");
    return path == nullptr ? "coverage.dat" : path;
  }

  std::string path_ = path();
  std::map<std::string, std::uint64_t> counts_;
};

void add_counts(VerilatedContext& context) {
  static Counts counts;
  counts.add(context);
}

[[maybe_unused]] const bool watching = (at_end_of_model = add_counts, true);

}  // namespace
}  // namespace armature::test
