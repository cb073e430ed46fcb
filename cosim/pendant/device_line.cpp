#include "cosim/pendant/device_line.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>

#include "cosim/net/generic_address.hpp"
#include "cosim/net/listener.hpp"
#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

constexpr std::string_view kTcp = "tcp:";

[[noreturn]] void fail(const std::string& address, const std::string& what) {
  throw InputError{address, what + ": " + std::strerror(errno)};
}

FileDescriptor connect_to_port(const std::string& address) {
  const std::uint16_t port = parse_port(std::string_view{address}.substr(kTcp.size())).value_or(0);
  if (port == 0) throw InputError{address, "expected tcp:PORT with a port from 1 to 65535"};
  FileDescriptor socket{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  if (!socket) fail(address, "cannot connect");
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(port);
  name.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(socket.get(), generic_address(name), sizeof name) != 0) fail(address, "cannot connect");
  return socket;
}

// Sends the line with the token and reads its answer. The socket blocks.
void send_token(const std::string& address, const FileDescriptor& socket, const std::string& token) {
  const std::string line = "token " + token + "\n";
  if (send(socket.get(), line.data(), line.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(line.size())) {
    fail(address, "cannot send the token");
  }
  constexpr std::size_t kLongestAnswer = 200;
  std::string answer;
  for (char byte = 0; byte != '\n' && answer.size() < kLongestAnswer; answer += byte) {
    if (recv(socket.get(), &byte, 1, 0) != 1) break;
  }
  if (answer == "ok\n") return;
  if (answer.ends_with('\n')) answer.pop_back();
  throw InputError{address,
                   answer.empty() ? "the other end closed the line instead of an answer to the token" : answer};
}

FileDescriptor open_device(const std::string& path) {
  FileDescriptor device{open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)};
  if (!device) fail(path, "cannot open this line");
  termios settings{};
  if (tcgetattr(device.get(), &settings) != 0) throw InputError{path, "is no serial device or pseudo-terminal"};
  cfmakeraw(&settings);
  cfsetspeed(&settings, B115200);
  settings.c_cflag |= CLOCAL | CREAD;
  if (tcsetattr(device.get(), TCSANOW, &settings) != 0) fail(path, "cannot set 115200 baud");
  return device;
}

}  // namespace

DeviceLine::DeviceLine(const std::string& address, const std::string& token)
    : address_{address}, descriptor_{address.starts_with(kTcp) ? connect_to_port(address) : open_device(address)} {
  if (address.starts_with(kTcp) && !token.empty()) send_token(address, descriptor_, token);
  const int flags = fcntl(descriptor_.get(), F_GETFL);
  if (flags < 0 || fcntl(descriptor_.get(), F_SETFL, flags | O_NONBLOCK) != 0) fail(address_, "cannot use this line");
}

std::vector<std::uint8_t> DeviceLine::read(int other, int timeout_ms) {
  std::array<pollfd, 2> waiting{{{descriptor_.get(), POLLIN, 0}, {other, POLLIN, 0}}};
  static_cast<void>(::poll(waiting.data(), waiting.size(), timeout_ms));
  std::array<std::uint8_t, 512> bytes{};
  const ssize_t count = ::read(descriptor_.get(), bytes.data(), bytes.size());
  if (count > 0) return {bytes.begin(), bytes.begin() + count};
  if (count == 0 || (errno != EAGAIN && errno != EINTR)) {
    throw InputError{address_, "the other end has closed the line"};
  }
  return {};
}

void DeviceLine::write(std::span<const std::uint8_t> bytes) {
  unsent_.insert(unsent_.end(), bytes.begin(), bytes.end());
  while (!unsent_.empty()) {
    const ssize_t count = ::write(descriptor_.get(), unsent_.data(), unsent_.size());
    if (count <= 0) break;  // full, or closed: read() reports it
    unsent_.erase(unsent_.begin(), unsent_.begin() + count);
  }
}

}  // namespace armature::cosim
