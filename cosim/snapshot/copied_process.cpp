#include "cosim/snapshot/copied_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "cosim/net/file_descriptor.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& why) {
  throw std::runtime_error{"cannot copy this process: " + why};
}

struct OpenFile {
  int descriptor = -1;
  std::optional<off_t> place;  // of a regular file that is only read
};

std::optional<off_t> place_of_reader(int descriptor) {
  struct stat status {};
  const int flags = ::fcntl(descriptor, F_GETFL);
  if (flags < 0 || (flags & O_ACCMODE) != O_RDONLY) return std::nullopt;
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return ::lseek(descriptor, 0, SEEK_CUR);
}

// Before the copy, because this process moves the places afterwards.
std::vector<OpenFile> open_files() {
  std::vector<OpenFile> files;
  std::error_code error;
  for (fs::directory_iterator entry{"/proc/self/fd", error}, end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    int descriptor = -1;
    std::from_chars(name.data(), name.data() + name.size(), descriptor);
    files.push_back({descriptor, place_of_reader(descriptor)});
  }
  if (error) fail("/proc/self/fd: " + error.message());
  // That of the listing itself.
  std::erase_if(files, [](const OpenFile& file) { return ::fcntl(file.descriptor, F_GETFD) < 0; });
  return files;
}

void require_one_thread() {
  std::error_code error;
  const fs::directory_iterator threads{"/proc/self/task", error};
  if (error) fail("/proc/self/task: " + error.message());
  const auto count = std::distance(begin(threads), end(threads));
  if (count != 1) fail(fmt::format("it has {} threads", count));
}

// In the copy: the number of a descriptor gets another file. A program that the copy starts inherits the first three.
bool replace(int descriptor, int by) {
  constexpr int kStandardStreams = 3;
  if (descriptor < kStandardStreams) return ::dup2(by, descriptor) == descriptor;
  return ::dup3(by, descriptor, O_CLOEXEC) == descriptor;
}

// In the copy.
bool separate(const std::vector<OpenFile>& files, int kept) {
  const FileDescriptor nothing{::open("/dev/null", O_RDWR | O_CLOEXEC)};
  if (!nothing) return false;
  for (const OpenFile& file : files) {
    if (file.descriptor == kept) continue;
    if (!file.place) {
      if (!replace(file.descriptor, nothing.get())) return false;
      continue;
    }
    const std::string name = fmt::format("/proc/self/fd/{}", file.descriptor);
    const FileDescriptor own{::open(name.c_str(), O_RDONLY | O_CLOEXEC)};
    if (!own || ::lseek(own.get(), *file.place, SEEK_SET) != *file.place) return false;
    if (!replace(file.descriptor, own.get())) return false;
  }
  return true;
}

}  // namespace

pid_t copy_this_process(int kept) {
  require_one_thread();
  const std::vector<OpenFile> files = open_files();
  const pid_t original = ::getpid();
  const pid_t copy = ::fork();
  if (copy < 0) fail(fmt::format("{}; it needs more processes (ulimit -u) or more memory", std::strerror(errno)));
  if (copy > 0) return copy;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  // The original may have ended before.
  if (::getppid() != original || !separate(files, kept)) ::_exit(EXIT_FAILURE);
  return 0;
}

int wait_for_end(pid_t copy) {
  int status = 0;
  while (::waitpid(copy, &status, 0) < 0) {
    if (errno != EINTR) return -1;
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace armature::cosim
