#include "cosim/net/listener.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <filesystem>
#include <memory>
#include <string>

#include "cosim/net/generic_address.hpp"
#include "cosim/text/input_error.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Listener, UnderstandsPortsAndPaths) {
  EXPECT_EQ(parse_listen_address("tcp:5025").tcp_port, 5025);
  EXPECT_EQ(parse_listen_address("tcp:0").tcp_port, 0);
  EXPECT_EQ(parse_listen_address("tcp:65535").tcp_port, 65535);
  EXPECT_EQ(parse_listen_address("a/b.sock").path, "a/b.sock");
  EXPECT_FALSE(parse_listen_address("a/b.sock").tcp_port);
  for (const char* wrong : {"tcp:", "tcp:65536", "tcp:-1", "tcp:http", "tcp:80 ", "tcp:127.0.0.1:80"}) {
    EXPECT_THAT([&] { (void)parse_listen_address(wrong); },
                ThrowsMessage<InputError>(HasSubstr("expected a port 0..65535")))
        << wrong;
  }
  EXPECT_THAT([] { (void)parse_listen_address(""); }, ThrowsMessage<InputError>(HasSubstr("expected tcp:PORT or")));
  for (const char* wrong :
       {"udp:5", "http://localhost", "tcp6:80", "TCP:80", "127.0.0.1:5025", ":5025", "unix:a.sock", "a:b/c"}) {
    EXPECT_THAT([&] { (void)parse_listen_address(wrong); },
                ThrowsMessage<InputError>(HasSubstr(std::string{""} + wrong + ": expected tcp:PORT or")))
        << wrong;
  }
  for (const char* path : {"./udp:5", "/tmp/a:b", "a/b:c"}) EXPECT_EQ(parse_listen_address(path).path, path);
  EXPECT_NO_THROW((void)parse_listen_address(std::string(107, 'a')));
  EXPECT_THAT([] { (void)parse_listen_address(std::string(108, 'a')); },
              ThrowsMessage<InputError>(HasSubstr("at most 107 bytes")));
}

TEST(Listener, ListensOnLoopbackOnly) {
  const Listener listener{parse_listen_address("tcp:0")};
  sockaddr_in name{};
  socklen_t size = sizeof name;
  ASSERT_EQ(getsockname(listener.socket().get(), generic_address(name), &size), 0);
  EXPECT_EQ(name.sin_family, AF_INET);
  EXPECT_STREQ(inet_ntoa(name.sin_addr), "127.0.0.1");
  EXPECT_EQ(listener.name(), "tcp:" + std::to_string(ntohs(name.sin_port)));
  EXPECT_THAT([&] { Listener{parse_listen_address(listener.name())}; },
              ThrowsMessage<InputError>(HasSubstr("cannot listen: Address already in use")));
}

TEST(Listener, DrawsATokenForEveryPort) {
  const Listener first{parse_listen_address("tcp:0")}, second{parse_listen_address("tcp:0")};
  ASSERT_TRUE(first.token() && second.token());
  EXPECT_NE(*first.token(), *second.token());
}

TEST(Listener, MakesASocketForItsUserAndRemovesItAtTheEnd) {
  const test::TempFolder folder;
  const fs::path path = folder.path() / "s";
  {
    const Listener listener{parse_listen_address(path.string())};
    struct stat made {};
    ASSERT_EQ(stat(path.c_str(), &made), 0);
    EXPECT_TRUE(S_ISSOCK(made.st_mode));
    EXPECT_EQ(made.st_mode & 0777u, 0600u);
    EXPECT_EQ(listener.name(), path.string());
    EXPECT_FALSE(listener.token()) << "nobody else can connect";
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(Listener, LeavesAloneWhatIsNoSocket) {
  const test::TempFolder folder;
  const fs::path file = folder.write("precious", "keep");
  EXPECT_THAT([&] { Listener{parse_listen_address(file.string())}; },
              ThrowsMessage<InputError>(HasSubstr("exists and is not a socket")));
  EXPECT_EQ(test::read_file(file), "keep");
  const fs::path link = folder.path() / "link";
  fs::create_symlink(file, link);
  EXPECT_THAT([&] { Listener{parse_listen_address(link.string())}; },
              ThrowsMessage<InputError>(HasSubstr("exists and is not a socket")));
  EXPECT_TRUE(fs::is_symlink(link));
}

TEST(Listener, DoesNotTakeThePathOfAnotherServer) {
  const test::TempFolder folder;
  const std::string path = folder.path() / "s";
  const Listener first{parse_listen_address(path)};
  EXPECT_THAT([&] { Listener{parse_listen_address(path)}; },
              ThrowsMessage<InputError>(HasSubstr("another server listens there")));
  EXPECT_TRUE(fs::exists(path));
}

TEST(Listener, ReplacesASocketThatAKilledServerLeft) {
  const test::TempFolder folder;
  const std::string path = folder.path() / "s", kept = folder.path() / "kept";
  {
    const Listener killed{parse_listen_address(path)};
    fs::create_hard_link(path, kept);
  }
  fs::rename(kept, path);
  ASSERT_TRUE(fs::is_socket(path));
  const Listener listener{parse_listen_address(path)};
  EXPECT_TRUE(fs::is_socket(path));
}

TEST(Listener, DoesNotRemoveTheSocketOfItsSuccessor) {
  const test::TempFolder folder;
  const std::string path = folder.path() / "s";
  auto first = std::make_unique<Listener>(parse_listen_address(path));
  fs::remove(path);
  const Listener second{parse_listen_address(path)};
  first.reset();
  EXPECT_TRUE(fs::is_socket(path));
}

TEST(Listener, SaysWhyAPathCannotBeUsed) {
  EXPECT_THAT([] { Listener{parse_listen_address("/nonexistent/folder/s")}; },
              ThrowsMessage<InputError>(HasSubstr("cannot create the socket: No such file or directory")));
}

}  // namespace
}  // namespace armature::cosim
