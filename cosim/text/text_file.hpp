// Whole text files, read and replaced in one step.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace armature::cosim {

// Throws InputError when the file cannot be read.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& file);

// Throws InputError when `file` cannot be created or written, as far as its permissions and its folder tell; touches
// nothing. For finding out before a run, not after it.
void require_writable(const std::filesystem::path& file);

// Writes a new file beside `file` and renames it, so that a reader never sees half of it; what is there and is no plain
// file (a link, a device, a pipe) is written in place. Creates missing folders.
// Throws std::runtime_error naming the file and the cause.
void replace_text_file(const std::filesystem::path& file, std::string_view text);

}  // namespace armature::cosim
