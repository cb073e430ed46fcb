// Whole text files, read and replaced in one step.
#pragma once

#include <cstddef>
#include <filesystem>
#include <istream>
#include <string>
#include <string_view>

namespace armature::cosim {

// Largest size of a file of numbers: more than any list of poses or log of a serial line needs, but not all of memory.
inline constexpr std::size_t kMaxTableBytes = std::size_t{256} << 20U;

// A regular file, or a link to one.
[[nodiscard]] bool is_file(const std::filesystem::path& path);

// "a folder", "a device", ...: the kind of a file that is not regular, for messages.
[[nodiscard]] std::string_view file_kind(const std::filesystem::file_status& status);

// Throws InputError when `file` is anything but a regular file or a link to one, such as a pipe, which could make the
// reader wait forever. A missing file passes, because opening it reports the error.
void require_regular_file(const std::filesystem::path& file);

// The whole text. Throws InputError when it cannot be read, has more than `most_bytes`, or is no UTF-8: a mark of
// another encoding, a NUL byte. It stops reading at the limit.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& file,
                                         std::size_t most_bytes = static_cast<std::size_t>(-1));
// The bytes of a file, whatever they are. Throws InputError when it cannot be read or has more than `most_bytes`.
[[nodiscard]] std::string read_binary_file(const std::filesystem::path& file, std::size_t most_bytes);
// A text that must be ASCII; the error names the line of a character that is not.
[[nodiscard]] std::string read_ascii_file(const std::filesystem::path& file, std::size_t most_bytes);
// The text of a stream, as read_text_file() reads it; `name` is for messages.
[[nodiscard]] std::string read_text(std::istream& stream, const std::string& name, std::size_t most_bytes);

// Throws InputError when the permissions or the folder do not allow to create or write `file`. Changes nothing. Called
// before a run, so that the error does not come after it.
void require_writable(const std::filesystem::path& file);

// Writes a new file beside `file` and renames it, so that a reader never sees half of it and a failure leaves the old
// one; what is there and is no plain file (a link, a device, a pipe) is written in place. The permissions stay. Creates
// missing folders. Throws InputError naming the file and the cause.
void replace_text_file(const std::filesystem::path& file, std::string_view text);

}  // namespace armature::cosim
