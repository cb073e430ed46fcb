#include "cosim/cli/options/output_files.hpp"

#include <algorithm>
#include <system_error>

#include "cosim/golden/golden.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

// The path that a file of this name gets when it is created. Links are followed, even dangling ones.
fs::path destination(fs::path file) {
  constexpr int kMaxLinks = 40;
  std::error_code ignored;
  for (int i = 0; i < kMaxLinks && fs::is_symlink(fs::symlink_status(file, ignored)); ++i) {
    file = file.parent_path() / fs::read_symlink(file, ignored);
  }
  const fs::path canonical = fs::weakly_canonical(fs::absolute(file, ignored), ignored);
  return ignored ? file : canonical;
}

// Whether both names mean one regular file, now or after its creation. Two outputs may share a device or a pipe.
bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  const fs::file_status status = fs::status(a, ignored);
  if (fs::exists(status)) return fs::is_regular_file(status) && fs::equivalent(a, b, ignored);
  return destination(a) == destination(b);
}

void require_usable(const fs::path& file, const std::string& what, Writing writing) {
  require_writable(file);
  std::error_code ignored;
  const fs::file_status named = fs::symlink_status(file, ignored);
  if (writing == Writing::kReplaced && fs::exists(named) && !fs::is_regular_file(named)) {
    throw InputError{file.string(), "is " + std::string{file_kind(named)} + ", which " + what +
                                        " would replace by a file; expected a regular file or none"};
  }
  const fs::file_status there = fs::status(file, ignored);
  if (fs::is_socket(there) || fs::is_block_file(there)) {
    throw InputError{file.string(), "is " + std::string{file_kind(there)} + ", expected a file for " + what};
  }
}

}  // namespace

void OutputFiles::reads(const fs::path& file) {
  inputs_.push_back(file);
}

void OutputFiles::reads(const Scenario& scenario) {
  reads(scenario.file);
  reads(scenario.robot.source.file);
  reads(fs::path{scenario.directory} / kGoldenFile);
}

void OutputFiles::writes(const fs::path& file, const std::string& what, Writing writing) {
  if (file.empty()) throw InputError{what, "expected the name of a file, found an empty one"};
  require_usable(file, what, writing);
  for (const fs::path& input : inputs_) {
    if (!same_file(file, input)) continue;
    throw InputError{file.string(), "is an input of this command, expected another file for " + what};
  }
  for (const Named& other : outputs_) {
    if (!same_file(file, other.file)) continue;
    throw InputError{file.string(), "is written as " + other.what + ", expected another file for " + what};
  }
  outputs_.push_back({file, what});
}

}  // namespace armature::cosim
