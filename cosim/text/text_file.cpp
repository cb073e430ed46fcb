#include "cosim/text/text_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "cosim/text/byte_order_mark.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

void write_text_file(const std::filesystem::path& file, std::string_view text) {
  errno = 0;
  std::ofstream stream{file, std::ios::binary | std::ios::trunc};
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.flush();
  if (!stream) throw InputError{file.string(), std::string{"cannot write: "} + std::strerror(errno)};
}

// An empty file beside `file` that was not there before, removed again unless it is renamed.
class NewFile {
 public:
  explicit NewFile(const std::filesystem::path& file) {
    for (int attempt = 0; attempt < 100; ++attempt) {
      path_ = file;
      path_ += ".new" + (attempt == 0 ? std::string{} : std::to_string(attempt));
      const int descriptor = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor >= 0) {
        close(descriptor);
        return;
      }
      if (errno != EEXIST) break;
    }
    throw InputError{file.string(), std::string{"cannot write: "} + std::strerror(errno)};
  }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  ~NewFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::ifstream opened(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw InputError{file.string(), "is a folder, expected a file"};
  errno = 0;
  std::ifstream stream{file, std::ios::binary};
  if (!stream) throw InputError{file.string(), std::string{"cannot open: "} + std::strerror(errno)};
  return stream;
}

// Gives each part of a stream that was read to check(), with the place where it begins in what was read.
template <class Check>
std::string read_parts(std::istream& stream, const std::string& name, std::size_t most_bytes, const Check& check) {
  constexpr std::size_t kChunk = std::size_t{64} * 1024;
  std::string text;
  while (stream) {
    const std::size_t before = text.size();
    text.resize(before + kChunk);
    stream.read(text.data() + before, kChunk);
    text.resize(before + static_cast<std::size_t>(stream.gcount()));
    check(text, before);
    if (text.size() > most_bytes) {
      throw InputError{name, "is too large, expected at most " + std::to_string(most_bytes >> 20U) + " MiB"};
    }
  }
  if (stream.bad()) throw InputError{name, "cannot read"};
  return text;
}

}  // namespace

bool is_file(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

std::string_view file_kind(const std::filesystem::file_status& status) {
  using std::filesystem::file_type;
  switch (status.type()) {
    case file_type::directory:
      return "a folder";
    case file_type::fifo:
      return "a pipe";
    case file_type::socket:
      return "a socket";
    case file_type::symlink:
      return "a symbolic link";
    case file_type::block:
    case file_type::character:
      return "a device";
    default:
      return "no regular file";
  }
}

void require_regular_file(const std::filesystem::path& file) {
  std::error_code ignored;
  const auto status = std::filesystem::status(file, ignored);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return;
  throw InputError{file.string(), "is " + std::string{file_kind(status)} + ", expected a file"};
}

std::string read_text_file(const std::filesystem::path& file, std::size_t most_bytes) {
  std::ifstream stream = opened(file);
  return read_text(stream, file.string(), most_bytes);
}

std::string read_binary_file(const std::filesystem::path& file, std::size_t most_bytes) {
  std::ifstream stream = opened(file);
  return read_parts(stream, file.string(), most_bytes, [](const std::string&, std::size_t) {});
}

std::string read_ascii_file(const std::filesystem::path& file, std::size_t most_bytes) {
  std::string text = read_text_file(file, most_bytes);
  const auto odd = std::ranges::find_if(text, [](char one) { return static_cast<unsigned char>(one) >= 0x80; });
  if (odd != text.end()) {
    const auto line = static_cast<int>(1 + std::count(text.begin(), odd, '\n'));
    throw InputError{Problem{file.string(), Origin{line, 0, {}}, {}, "holds a character that is not ASCII"}};
  }
  return text;
}

std::string read_text(std::istream& stream, const std::string& name, std::size_t most_bytes) {
  return read_parts(stream, name, most_bytes, [&](const std::string& text, std::size_t before) {
    if (const std::string_view encoding = foreign_encoding(text); !encoding.empty()) {
      throw InputError{name, "is " + std::string{encoding} + " text, expected UTF-8"};
    }
    if (const std::size_t nul = text.find('\0', before); nul != std::string::npos) {
      const auto line = static_cast<int>(1 + std::count(text.data(), text.data() + nul, '\n'));
      throw InputError{Problem{name, Origin{line, 0, {}}, {}, "holds a NUL byte, expected UTF-8 text"}};
    }
  });
}

void require_writable(const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) throw InputError{file.string(), "is a folder, expected a file"};
  std::error_code error;
  const fs::file_status there = fs::status(file, error);
  if (there.type() == fs::file_type::none) {  // such as a name that is too long
    throw InputError{file.string(), "cannot write this file: " + error.message()};
  }
  const bool exists = fs::exists(there);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path{"."};
  const int denied = exists ? access(file.c_str(), W_OK) : access(folder.c_str(), W_OK | X_OK);
  if (denied != 0) throw InputError{file.string(), std::string{"cannot write this file: "} + std::strerror(errno)};
  if (!exists && !fs::is_directory(folder, ignored)) {
    throw InputError{file.string(), "cannot write this file: " + folder.string() + " is not a folder"};
  }
}

void replace_text_file(const std::filesystem::path& file, std::string_view text) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const auto status = fs::symlink_status(file, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    write_text_file(file, text);
    return;
  }
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error) throw InputError{file.string(), "cannot write: " + error.message()};
  const NewFile fresh{file};
  write_text_file(fresh.path(), text);
  if (fs::exists(status)) fs::permissions(fresh.path(), status.permissions(), ignored);
  fs::rename(fresh.path(), file, error);
  if (error) throw InputError{file.string(), "cannot write: " + error.message()};
}

}  // namespace armature::cosim
