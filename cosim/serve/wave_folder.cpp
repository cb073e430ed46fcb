#include "cosim/serve/wave_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "cosim/serve/command_words.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr int kFolder = O_PATH | O_DIRECTORY | O_CLOEXEC;

[[noreturn]] void refuse_wave(const fs::path& file, const std::string& why) {
  throw CommandRefused{fmt::format("{} {}", in_quotes(file.native()), why)};
}

[[noreturn]] void refuse_errno(const fs::path& file) {
  throw CommandRefused{
      fmt::format("cannot write {}: {}", in_quotes(file.native()), std::generic_category().message(errno))};
}

void require_name(const fs::path& file) {
  if (file.extension() != ".vcd" || file.native().find('\0') != std::string::npos) {
    throw CommandRefused{fmt::format("FILE must end in .vcd, found {}", in_quotes(file.native()))};
  }
  if (file.is_absolute()) refuse_wave(file, "must be a name below the folder of --out, not an absolute path");
  for (const fs::path& part : file) {
    if (part == "..") refuse_wave(file, "must be a name below the folder of --out, without '..'");
  }
}

// Only a regular file with one name is written; not a pipe, a device or a link.
void require_plain(const struct stat& there, const fs::path& file) {
  if (!S_ISREG(there.st_mode)) refuse_wave(file, "exists and is no plain file");
  if (there.st_nlink > 1) refuse_wave(file, "exists and has a second name (a hard link)");
}

}  // namespace

WaveFolder::WaveFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  folder_ = FileDescriptor{::open(folder.c_str(), kFolder)};
  if (!folder_) {
    throw InputError{
        "--out " + folder.string(),
        "cannot use the folder: " + (error ? error : std::error_code{errno, std::generic_category()}).message()};
  }
}

FileDescriptor WaveFolder::open(const fs::path& file) const {
  if (!folder_) throw CommandRefused{"vcd FILE needs a folder for its files: start the server with --out DIR"};
  require_name(file);
  FileDescriptor below;
  const auto folder = [&] { return below ? below.get() : folder_.get(); };
  for (const fs::path& part : file.parent_path()) {
    FileDescriptor next{::openat(folder(), part.c_str(), kFolder | O_NOFOLLOW)};
    if (!next) refuse_errno(file);
    below = std::move(next);
  }
  const fs::path name = file.filename();
  struct stat there {};
  // Checked before opening, because opening a device can have an effect.
  if (::fstatat(folder(), name.c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0) require_plain(there, file);
  constexpr mode_t kMode = S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH;
  FileDescriptor opened{
      ::openat(folder(), name.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, kMode)};
  if (!opened || ::fstat(opened.get(), &there) != 0) refuse_errno(file);
  require_plain(there, file);
  return opened;
}

}  // namespace armature::cosim
