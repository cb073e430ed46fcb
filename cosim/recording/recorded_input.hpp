// The content of an input file of a run, read again.
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace armature::cosim {

struct RecordedInput {
  std::string content{};  // empty: see `problem`
  std::string problem{};  // why there is no content, in words; empty: there is one
};

// `file`: as `inputs` of the summary names it. A file that has another digest than there is not given, because it is
// not what ran; nor is one of more than `most_bytes`.
[[nodiscard]] RecordedInput recorded_input(const nlohmann::ordered_json& summary, const std::filesystem::path& file,
                                           std::size_t most_bytes);

}  // namespace armature::cosim
