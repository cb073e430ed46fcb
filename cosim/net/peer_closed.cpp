#include "cosim/net/peer_closed.hpp"

#include <linux/inet_diag.h>
#include <linux/netlink.h>
#include <linux/sock_diag.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "cosim/net/generic_address.hpp"

namespace armature::cosim {
namespace {

enum class End : std::uint8_t { kHeld, kNotHeld, kNotFound };

// Whether a program still has the end `local` of a TCP connection of this machine, as ss(8) shows it. The kernel finds
// a closed connection for a while, but no file belongs to it.
End end_of(const FileDescriptor& kernel, const sockaddr_in& local, const sockaddr_in& remote) {
  struct {
    nlmsghdr header;
    inet_diag_req_v2 question;
  } ask{};
  ask.header = {.nlmsg_len = sizeof ask,
                .nlmsg_type = SOCK_DIAG_BY_FAMILY,
                .nlmsg_flags = NLM_F_REQUEST,
                .nlmsg_seq = 0,
                .nlmsg_pid = 0};
  ask.question.sdiag_family = AF_INET;
  ask.question.sdiag_protocol = IPPROTO_TCP;
  ask.question.idiag_states = ~0u;
  ask.question.id.idiag_sport = local.sin_port;
  ask.question.id.idiag_dport = remote.sin_port;
  ask.question.id.idiag_src[0] = local.sin_addr.s_addr;
  ask.question.id.idiag_dst[0] = remote.sin_addr.s_addr;
  ask.question.id.idiag_cookie[0] = ask.question.id.idiag_cookie[1] = INET_DIAG_NOCOOKIE;
  if (::send(kernel.get(), &ask, sizeof ask, 0) != static_cast<ssize_t>(sizeof ask)) return End::kNotFound;

  // The kernel has answered when send() returns.
  std::array<std::byte, 4096> answer{};
  const ssize_t size = ::recv(kernel.get(), answer.data(), answer.size(), MSG_DONTWAIT);
  nlmsghdr header{};
  inet_diag_msg found{};
  if (size < static_cast<ssize_t>(NLMSG_HDRLEN + sizeof found)) return End::kNotFound;
  std::memcpy(&header, answer.data(), sizeof header);
  std::memcpy(&found, answer.data() + NLMSG_HDRLEN, sizeof found);
  // If the connection does not exist, the kernel returns a listener of that port.
  if (header.nlmsg_type != SOCK_DIAG_BY_FAMILY || found.id.idiag_dport != remote.sin_port) return End::kNotFound;
  return found.idiag_inode == 0 ? End::kNotHeld : End::kHeld;
}

}  // namespace

bool peer_closed(const FileDescriptor& socket) {
  pollfd state{socket.get(), 0, 0};
  if (::poll(&state, 1, 0) > 0) return true;  // a Unix socket that was closed, any socket that was reset
  sockaddr_in here{}, there{};
  socklen_t here_size = sizeof here, there_size = sizeof there;
  if (::getsockname(socket.get(), generic_address(here), &here_size) != 0 ||
      ::getpeername(socket.get(), generic_address(there), &there_size) != 0) {
    return true;
  }
  if (here.sin_family != AF_INET) return false;
  const FileDescriptor kernel{::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_SOCK_DIAG)};
  if (!kernel) return false;
  const End end = end_of(kernel, there, here);
  if (end != End::kNotFound) return end == End::kNotHeld;
  // Either the kernel has removed the other end already, or it does not support the query. In the second case it does
  // not find our end either.
  return end_of(kernel, here, there) != End::kNotFound;
}

}  // namespace armature::cosim
