#include "cosim/scenario/text_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "cosim/scenario/input_error.hpp"

namespace armature::cosim {

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

void replace_text_file(const std::filesystem::path& file, std::string_view text) {
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  std::filesystem::path fresh = file;
  fresh += ".new";
  errno = 0;
  {
    std::ofstream stream{fresh, std::ios::binary | std::ios::trunc};
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.flush();
    if (!stream) throw std::runtime_error{"cannot write " + fresh.string() + ": " + std::strerror(errno)};
  }
  std::filesystem::rename(fresh, file);
}

}  // namespace armature::cosim
