#include "cosim/net/listener.hpp"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include <cerrno>
#include <cstring>

#include "cosim/net/generic_address.hpp"
#include "cosim/net/stream_socket.hpp"
#include "cosim/net/token.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/number_text.hpp"

namespace armature::cosim {
namespace {

constexpr std::string_view kTcpPrefix = "tcp:";
constexpr std::string_view kExpected = "expected tcp:PORT or the path of a Unix socket";
constexpr int kListenBacklog = 16;

[[noreturn]] void refuse_address(const std::string& where, std::string_view why) {
  throw InputError{where, std::string{why}};
}

[[noreturn]] void refuse_errno(const std::string& where, const std::string& what) {
  refuse_address(where, what + ": " + std::generic_category().message(errno));
}

bool server_listens(const sockaddr_un& name) {
  const FileDescriptor probe = stream_socket(AF_UNIX);
  // EAGAIN: a server listens, and its queue of clients is full.
  return ::connect(probe.get(), generic_address(name), sizeof name) == 0 || errno == EAGAIN;
}

}  // namespace

std::optional<std::uint16_t> parse_port(std::string_view digits) {
  return parsed_number<std::uint16_t>(digits);
}

ListenAddress parse_listen_address(std::string_view text) {
  ListenAddress address;
  if (text.starts_with(kTcpPrefix)) {
    address.tcp_port = parse_port(text.substr(kTcpPrefix.size()));
    if (!address.tcp_port) refuse_address(std::string{text}, "expected a port 0..65535 after tcp: (0: any free one)");
    return address;
  }
  constexpr std::size_t kLongest = sizeof(sockaddr_un::sun_path) - 1;
  if (text.empty()) refuse_address("''", kExpected);
  const std::size_t mark = text.find_first_of("/:");
  if (mark != std::string_view::npos && text[mark] == ':') {
    refuse_address(std::string{text}, fmt::format("{} (./{} would be one)", kExpected, text));
  }
  if (text.size() > kLongest) {
    refuse_address(std::string{text}, "the path of a Unix socket has at most " + std::to_string(kLongest) + " bytes");
  }
  address.path = text;
  return address;
}

Listener::Listener(const ListenAddress& address) : address_{address} {
  if (address.tcp_port) {
    listen_on_port(*address.tcp_port);
  } else {
    listen_on_path(address.path);
  }
}

void Listener::listen_on_port(std::uint16_t port) try {
  LoopbackPort listening = listen_on_loopback(port, kListenBacklog);
  socket_ = std::move(listening.socket);
  address_.tcp_port = listening.port;
  token_ = random_token();
} catch (const std::system_error& error) {
  refuse_address(name(), error.what());
}

void Listener::listen_on_path(const std::filesystem::path& path) {
  sockaddr_un name{};
  name.sun_family = AF_UNIX;
  std::memcpy(name.sun_path, path.c_str(), path.native().size());

  struct stat there {};
  if (::lstat(path.c_str(), &there) == 0) {
    if (!S_ISSOCK(there.st_mode)) refuse_address(path, "exists and is not a socket; it stays unchanged");
    if (server_listens(name)) refuse_address(path, "another server listens there");
    if (::unlink(path.c_str()) != 0) refuse_errno(path, "cannot remove the socket that a server left behind");
  }
  FileDescriptor socket = stream_socket(AF_UNIX);
  const mode_t before = ::umask(S_IXUSR | S_IRWXG | S_IRWXO);
  const int bound = ::bind(socket.get(), generic_address(name), sizeof name);
  const int error = errno;
  ::umask(before);
  errno = error;
  if (bound != 0) refuse_errno(path, "cannot create the socket");
  if (::lstat(path.c_str(), &there) == 0) device_ = there.st_dev, inode_ = there.st_ino;
  if (::listen(socket.get(), kListenBacklog) != 0) refuse_errno(path, "cannot listen");
  socket_ = std::move(socket);
}

Listener::~Listener() {
  if (address_.tcp_port || !socket_) return;
  struct stat there {};
  const bool ours = ::lstat(address_.path.c_str(), &there) == 0 && there.st_dev == device_ && there.st_ino == inode_;
  if (ours) ::unlink(address_.path.c_str());
}

std::string Listener::name() const {
  return address_.tcp_port ? std::string{kTcpPrefix} + std::to_string(*address_.tcp_port) : address_.path.string();
}

}  // namespace armature::cosim
