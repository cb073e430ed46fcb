#include "cosim/net/peer_closed.hpp"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <thread>
#include <utility>

#include "cosim/net/generic_address.hpp"
#include "cosim/net/stream_socket.hpp"

namespace armature::cosim {
namespace {

struct Pair {
  FileDescriptor near, far;
};

FileDescriptor accepted(const LoopbackPort& port) {
  FileDescriptor near;
  while (!near) near = accept_client(port.socket);
  return near;
}

Pair tcp_pair(int family) {
  const LoopbackPort port = listen_on_loopback(0, 1);
  FileDescriptor far{socket(family, SOCK_STREAM, 0)};
  int result = -1;
  if (family == AF_INET) {
    sockaddr_in name{};
    name.sin_family = AF_INET;
    name.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    name.sin_port = htons(port.port);
    result = connect(far.get(), generic_address(name), sizeof name);
  } else {
    // The address of version 4 in version 6, as many libraries connect.
    sockaddr_in6 name{};
    name.sin6_family = AF_INET6;
    name.sin6_addr = {{{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF, 127, 0, 0, 1}}};
    name.sin6_port = htons(port.port);
    result = connect(far.get(), generic_address(name), sizeof name);
  }
  if (result != 0) return {};
  return {accepted(port), std::move(far)};
}

Pair unix_pair() {
  int both[2] = {-1, -1};
  EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, both), 0);
  return {FileDescriptor{both[0]}, FileDescriptor{both[1]}};
}

class PeerClosed : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    pair = GetParam() == AF_UNIX ? unix_pair() : tcp_pair(GetParam());
    if (!pair.near) GTEST_SKIP() << "this machine has no such sockets";
  }
  // What the system does with the close takes no time that matters, but may not be done when close() returns.
  [[nodiscard]] bool closed_in_the_end() const {
    for (int i = 0; i < 10'000 && !peer_closed(pair.near); ++i) std::this_thread::yield();
    return peer_closed(pair.near);
  }
  Pair pair;
};

TEST_P(PeerClosed, TellsAClosedConnectionFromOneThatOnlySendsNoMore) {
  EXPECT_FALSE(peer_closed(pair.near));
  ASSERT_EQ(shutdown(pair.far.get(), SHUT_WR), 0);
  for (int i = 0; i < 100; ++i) ASSERT_FALSE(peer_closed(pair.near)) << "it still reads";
  pair.far.close();
  EXPECT_TRUE(closed_in_the_end());
}

TEST_P(PeerClosed, SeesACloseBehindBytesThatWereNotRead) {
  ASSERT_EQ(send(pair.far.get(), "time\n", 5, 0), 5);
  EXPECT_FALSE(peer_closed(pair.near));
  pair.far.close();
  EXPECT_TRUE(closed_in_the_end());
}

TEST_P(PeerClosed, SeesAReset) {
  ASSERT_EQ(send(pair.near.get(), "ok\n", 3, 0), 3);
  pair.far.close();  // with a byte unread
  EXPECT_TRUE(closed_in_the_end());
}

INSTANTIATE_TEST_SUITE_P(Over, PeerClosed, testing::Values(AF_UNIX, AF_INET, AF_INET6), [](const auto& which) {
  return which.param == AF_UNIX ? "Unix" : which.param == AF_INET ? "Tcp" : "TcpOfVersion6";
});

}  // namespace
}  // namespace armature::cosim
