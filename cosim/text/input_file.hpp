// An input file of a run, as it was read. The results name it with its digest.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "cosim/text/sha256.hpp"

namespace armature::cosim {

struct InputFile {
  std::string file;    // path as given, or as found
  std::string sha256;  // of its bytes, 64 digits
};

[[nodiscard]] inline InputFile input_file(const std::filesystem::path& file, std::string_view content) {
  return {.file = file.string(), .sha256 = sha256_hex(content)};
}

}  // namespace armature::cosim
