#include <fcntl.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "cosim/net/file_descriptor.hpp"
#include "cosim/serial/host/host_channel.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_with_errno(const std::string& what) {
  throw InputError{what, std::strerror(errno)};
}

class PtyChannel final : public HostChannel {
 public:
  explicit PtyChannel(const std::optional<fs::path>& link) {
    master_ = FileDescriptor{posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)};
    if (!master_ || grantpt(master_.get()) != 0 || unlockpt(master_.get()) != 0)
      fail_with_errno("cannot open a pseudo-terminal");
    std::array<char, 128> name{};
    if (ptsname_r(master_.get(), name.data(), name.size()) != 0) fail_with_errno("cannot open a pseudo-terminal");
    path_ = name.data();
    // The slave side is open here, too, so that the terminal keeps its settings and its bytes while there is no client.
    slave_ = FileDescriptor{open(path_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)};
    termios settings{};
    if (!slave_ || tcgetattr(slave_.get(), &settings) != 0) fail_with_errno(path_);
    cfmakeraw(&settings);
    if (tcsetattr(slave_.get(), TCSANOW, &settings) != 0) fail_with_errno(path_);
    const int flags = fcntl(master_.get(), F_GETFL);
    if (flags < 0 || fcntl(master_.get(), F_SETFL, flags | O_NONBLOCK) != 0) fail_with_errno(path_);
    if (link) make_link(*link);
  }

  PtyChannel(const PtyChannel&) = delete;
  PtyChannel& operator=(const PtyChannel&) = delete;

  ~PtyChannel() override {
    std::error_code ignored;
    if (link_ && fs::read_symlink(*link_, ignored) == path_) fs::remove(*link_, ignored);
  }

  [[nodiscard]] std::string address() const override {
    return link_ ? path_ + " (link " + link_->string() + ")" : path_;
  }

  std::size_t read(std::span<std::uint8_t> bytes) override {
    const ssize_t count = ::read(master_.get(), bytes.data(), bytes.size());
    return count > 0 ? static_cast<std::size_t>(count) : 0;
  }

  std::size_t write(std::span<const std::uint8_t> bytes) override {
    const ssize_t count = ::write(master_.get(), bytes.data(), bytes.size());
    return count > 0 ? static_cast<std::size_t>(count) : 0;
  }

  [[nodiscard]] std::size_t unread() const override {
    int count = 0;
    return ioctl(slave_.get(), FIONREAD, &count) == 0 ? static_cast<std::size_t>(count) : 0;
  }

 private:
  void make_link(const fs::path& link) {
    std::error_code ignored;
    if (fs::is_symlink(fs::symlink_status(link, ignored))) {
      const fs::path target = fs::read_symlink(link, ignored);
      const bool to_terminal = target.parent_path() == fs::path{path_}.parent_path();
      // The link of a run that was killed. Its terminal may have the same number as the new one.
      if (to_terminal && (target == path_ || !fs::exists(target, ignored)))
        fs::remove(link, ignored);
      else if (to_terminal)
        throw InputError{link.string(), "is in use: it points to " + target.string()};
    }
    std::error_code error;
    fs::create_symlink(path_, link, error);
    if (error) throw InputError{link.string(), "cannot create this link: " + error.message()};
    link_ = link;
  }

  FileDescriptor master_;
  FileDescriptor slave_;
  std::string path_;
  std::optional<fs::path> link_;
};

}  // namespace

std::unique_ptr<HostChannel> open_pty(const std::optional<fs::path>& link) {
  return std::make_unique<PtyChannel>(link);
}

}  // namespace armature::cosim
