// Whole text files, read and replaced in one step.
#pragma once

#include <cstddef>
#include <filesystem>
#include <istream>
#include <string>
#include <string_view>

namespace armature::cosim {

// What users may give for one file of numbers: far beyond any list of poses or log of a line, and not all of memory.
inline constexpr std::size_t kMostTableBytes = std::size_t{256} << 20U;

// A regular file, or a link to one.
[[nodiscard]] bool is_file(const std::filesystem::path& path);

// "a folder", "a device", ... as messages name what is no regular file.
[[nodiscard]] std::string_view file_kind(const std::filesystem::file_status& status);

// Throws InputError when `file` is anything but a regular file or a link to one, such as a pipe, which could make the
// reader wait for ever. What does not exist passes: opening it tells.
void require_regular_file(const std::filesystem::path& file);

// The whole text. Throws InputError when it cannot be read, has more than `most_bytes`, or is no UTF-8: a mark of
// another encoding, a NUL byte. Then no more than that has been read.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& file,
                                         std::size_t most_bytes = static_cast<std::size_t>(-1));
// The same for a stream; `name` is for messages.
[[nodiscard]] std::string read_text(std::istream& stream, const std::string& name, std::size_t most_bytes);

// Throws InputError when `file` cannot be created or written, as far as its permissions and its folder tell; touches
// nothing. For finding out before a run, not after it.
void require_writable(const std::filesystem::path& file);

// Writes a new file beside `file` and renames it, so that a reader never sees half of it and a failure leaves the old
// one; what is there and is no plain file (a link, a device, a pipe) is written in place. The permissions stay. Creates
// missing folders. Throws InputError naming the file and the cause.
void replace_text_file(const std::filesystem::path& file, std::string_view text);

}  // namespace armature::cosim
