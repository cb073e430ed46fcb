#include "cosim/run/run_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <system_error>
#include <thread>
#include <utility>

#include "cosim/text/input_error.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMarkName = "unfinished";

[[noreturn]] void refuse_file(const fs::path& file, const std::string& what) {
  throw InputError{file.string(), what + ": " + std::strerror(errno)};
}

// The process that the mark names: "process 1234", or "another process".
std::string holder(const FileDescriptor& mark) {
  std::array<char, 64> text{};
  const ssize_t bytes = ::pread(mark.get(), text.data(), text.size() - 1, 0);
  std::string line{text.data(), static_cast<std::size_t>(bytes > 0 ? bytes : 0)};
  line.erase(std::min(line.find('\n'), line.size()));
  return line.empty() ? "another process" : line;
}

// False while another process has the lock. On a file system without locks it is always true.
bool lock(const FileDescriptor& mark, int kind) {
  return ::flock(mark.get(), kind | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

// Waits a little, because why_unfinished() in another process holds the lock for a moment.
bool lock_patiently(const FileDescriptor& mark) {
  constexpr int kTries = 10;
  constexpr std::chrono::milliseconds kPause{10};
  for (int i = 0; i < kTries; ++i) {
    if (lock(mark, LOCK_EX)) return true;
    std::this_thread::sleep_for(kPause);
  }
  return false;
}

// Between opening and locking, another process may have removed the file and created it again.
bool still_there(const FileDescriptor& mark, const fs::path& file) {
  struct stat opened {};
  struct stat found {};
  return ::fstat(mark.get(), &opened) == 0 && ::lstat(file.c_str(), &found) == 0 && opened.st_ino == found.st_ino &&
         opened.st_dev == found.st_dev;
}

FileDescriptor open_mark(const fs::path& folder) {
  return FileDescriptor{::open((folder / kMarkName).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK)};
}

}  // namespace

void create_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError{folder.string(), "cannot create this folder: " + error.message()};
}

RunFolder::RunFolder(fs::path folder) : folder_{std::move(folder)} {
  create_folder(folder_);
  const fs::path file = folder_ / kMarkName;
  while (true) {
    mark_ = FileDescriptor{::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666)};
    if (!mark_) refuse_file(file, "cannot write this file");
    if (!lock_patiently(mark_)) {
      throw InputError{folder_.string(), holder(mark_) +
                                             " is writing a run into this folder; wait for its end, or "
                                             "choose another one with --out"};
    }
    if (still_there(mark_, file)) break;
  }
  write_mark({});
}

void RunFolder::describe(const std::string& summary) {
  write_mark(summary);
}

void RunFolder::write_mark(const std::string& summary) {
  const std::string text = "process " + std::to_string(::getpid()) + "\n" + summary;
  const bool written = ::ftruncate(mark_.get(), 0) == 0 &&
                       ::pwrite(mark_.get(), text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
  if (!written) refuse_file(folder_ / kMarkName, "cannot write this file");
}

void RunFolder::finish() {
  std::error_code ignored;
  fs::remove(folder_ / kMarkName, ignored);
  mark_.close();
}

bool is_being_written(const fs::path& folder) {
  const FileDescriptor mark = open_mark(folder);
  return mark && !lock(mark, LOCK_SH);
}

std::optional<std::string> why_unfinished(const fs::path& folder) {
  const FileDescriptor mark = open_mark(folder);
  if (!mark) return std::nullopt;
  const bool ended = lock(mark, LOCK_SH);
  return ended ? "the run that wrote it was killed or failed in the middle" : holder(mark) + " is still writing it";
}

std::string unfinished_summary(const fs::path& folder) {
  const std::string text = read_text_file(folder / kMarkName, kMaxTableBytes);
  return text.substr(std::min(text.find('\n'), text.size()));
}

}  // namespace armature::cosim
