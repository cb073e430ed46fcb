// Whole text files, read and replaced in one step.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace armature::cosim {

// Throws InputError when the file cannot be read.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& file);

// Writes a new file beside `file` and renames it, so that a reader never sees half of it. Creates missing folders.
// Throws std::runtime_error naming the file and the cause.
void replace_text_file(const std::filesystem::path& file, std::string_view text);

}  // namespace armature::cosim
