#include "cosim/recording/recorded_input.hpp"

#include "cosim/text/json.hpp"
#include "cosim/text/sha256.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

RecordedInput read_again(const fs::path& file, const std::string& digest, std::size_t most_bytes) {
  if (!is_file(file)) return {.problem = "The file is no longer there."};
  if (fs::file_size(file) > most_bytes) return {.problem = "The file is too long to be shown."};
  std::string content = read_binary_file(file, most_bytes);
  if (sha256_hex(content) != digest) return {.problem = "The file has changed since the run."};
  return {.content = std::move(content)};
}

}  // namespace

RecordedInput recorded_input(const Json& summary, const fs::path& file, std::size_t most_bytes) {
  for (const Json& input : summary["inputs"]) {
    const fs::path one = input.value("file", "");
    if (one.lexically_normal() == file.lexically_normal())
      return read_again(one, input.value("sha256", ""), most_bytes);
  }
  return {.problem = "The run does not say where the file was."};
}

}  // namespace armature::cosim
