#include "cosim/text/text_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

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

}  // namespace

std::string read_text_file(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw InputError{file.string(), "is a folder, expected a file"};
  errno = 0;
  std::ifstream stream{file, std::ios::binary};
  if (!stream) throw InputError{file.string(), std::string{"cannot open: "} + std::strerror(errno)};
  std::string text{std::istreambuf_iterator<char>{stream}, {}};
  if (stream.bad()) throw InputError{file.string(), "cannot read"};
  return text;
}

void require_writable(const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) throw InputError{file.string(), "is a folder, expected a file"};
  const bool exists = fs::exists(file, ignored);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path{"."};
  const int denied = exists ? access(file.c_str(), W_OK) : access(folder.c_str(), W_OK | X_OK);
  if (denied != 0) throw InputError{file.string(), std::string{"cannot write this file: "} + std::strerror(errno)};
  if (!exists && !fs::is_directory(folder, ignored)) {
    throw InputError{file.string(), "cannot write this file: " + folder.string() + " is not a folder"};
  }
}

void replace_text_file(const std::filesystem::path& file, std::string_view text) {
  std::error_code ignored;
  const auto status = std::filesystem::symlink_status(file, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    write_text_file(file, text);
    return;
  }
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  std::filesystem::path fresh = file;
  fresh += ".new";
  write_text_file(fresh, text);
  std::filesystem::rename(fresh, file);
}

}  // namespace armature::cosim
