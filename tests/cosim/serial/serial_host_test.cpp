// The host's side of the serial line: pseudo-terminals and TCP ports, with clients that come and go.
#include <arpa/inet.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <termios.h>

#include <algorithm>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "cosim/net/file_descriptor.hpp"
#include "cosim/net/generic_address.hpp"
#include "cosim/serial/host/host_port.hpp"
#include "cosim/text/input_error.hpp"
#include "tests/cosim/support/temp_folder.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;
using test::TempFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr int kPatienceMs = 5'000;

FileDescriptor open_terminal(const fs::path& path) {
  FileDescriptor terminal{open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)};
  EXPECT_TRUE(static_cast<bool>(terminal)) << path;
  return terminal;
}

FileDescriptor connect_to(const std::string& place) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(std::stoi(place.substr(place.find(':') + 1))));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  FileDescriptor client{socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  EXPECT_EQ(connect(client.get(), generic_address(address), sizeof address), 0);
  return client;
}

void put(const FileDescriptor& client, const std::string& text) {
  ASSERT_EQ(write(client.get(), text.data(), text.size()), static_cast<ssize_t>(text.size()));
}

// Reads until `count` bytes have come.
std::string get(const FileDescriptor& client, std::size_t count) {
  std::string text;
  while (text.size() < count) {
    pollfd wait{.fd = client.get(), .events = POLLIN, .revents = 0};
    if (poll(&wait, 1, kPatienceMs) <= 0) break;
    std::vector<char> bytes(count - text.size());
    const ssize_t got = read(client.get(), bytes.data(), bytes.size());
    if (got <= 0) break;
    text.append(bytes.data(), static_cast<std::size_t>(got));
  }
  return text;
}

void exchange(HostPort& port) {
  std::vector<std::uint8_t> in;
  port.exchange(Cycles{}, 1, in);
  EXPECT_TRUE(in.empty());
}
void exchange(HostChannel& channel) {
  (void)channel.write({});
}

// Polls the port until `count` bytes have come from the client.
std::string poll_port(HostPort& port, std::size_t count, std::size_t room = 256) {
  std::vector<std::uint8_t> in;
  for (int ms = 0; ms < kPatienceMs && in.size() < count; ++ms) {
    port.exchange(Cycles{}, room, in);
    if (in.size() < count) poll(nullptr, 0, 1);
  }
  return {in.begin(), in.end()};
}

// A client that has sent the token and read the answer. What the channel sends further is not read.
template <class Server>
FileDescriptor admitted_client(Server& server) {
  FileDescriptor client = connect_to(server.address());
  put(client, "token " + server.token() + "\n");
  std::string answer;
  for (int ms = 0; ms < kPatienceMs && answer.size() < 3; ++ms) {
    exchange(server);
    pollfd wait{.fd = client.get(), .events = POLLIN, .revents = 0};
    if (poll(&wait, 1, 1) > 0) answer += get(client, 3 - answer.size());
  }
  EXPECT_EQ(answer, "ok\n");
  return client;
}

void send(HostPort& port, const std::string& text) {
  for (const char c : text) port.send(static_cast<std::uint8_t>(c));
  std::vector<std::uint8_t> in;
  port.exchange(Cycles{}, 0, in);
}

const std::string kEveryByte = [] {
  std::string all;
  for (int byte = 0; byte < 256; ++byte) all += static_cast<char>(byte);
  return all;
}();

// Takes what the test lets it take.
class Tap final : public HostChannel {
 public:
  [[nodiscard]] std::string address() const override { return "tap"; }
  std::size_t read(std::span<std::uint8_t>) override { return 0; }
  std::size_t write(std::span<const std::uint8_t> bytes) override {
    const std::size_t count = std::min(bytes.size(), room);
    got.append(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
    room -= count;
    return count;
  }
  [[nodiscard]] std::size_t unread() const override { return 0; }

  std::string got;
  std::size_t room = 0;
};

TEST(HostPort, KeepsTheOldestBytesAndCountsThoseThatFindNoRoom) {
  auto owned = std::make_unique<Tap>();
  Tap& tap = *owned;
  HostPort port{std::move(owned)};
  send(port, std::string(HostPort::kBufferBytes, 'k') + "lost");
  EXPECT_EQ(port.lost(), 4u);
  tap.room = 10;
  send(port, "");
  send(port, "0123456789lost too");
  EXPECT_EQ(port.lost(), 12u);
  tap.room = 1'000'000;
  send(port, "");
  EXPECT_EQ(tap.got, std::string(HostPort::kBufferBytes, 'k') + "0123456789");
  send(port, "again");
  EXPECT_TRUE(tap.got.ends_with("again"));
  EXPECT_EQ(port.lost(), 12u);
  EXPECT_EQ(port.finish(), 12u);
}

TEST(HostPty, IsTransparentForEveryByteBothWays) {
  HostPort port{open_host_channel("pty")};
  const FileDescriptor client = open_terminal(port.address());
  put(client, kEveryByte);
  EXPECT_EQ(poll_port(port, 256), kEveryByte);
  send(port, kEveryByte);
  EXPECT_EQ(get(client, 256), kEveryByte);
  EXPECT_EQ(port.finish(), 0u);
}

TEST(HostPty, AClientMayGoAndComeBackAndFindsWhatCameMeanwhile) {
  HostPort port{open_host_channel("pty")};
  {
    const FileDescriptor first = open_terminal(port.address());
    put(first, "one");
    EXPECT_EQ(poll_port(port, 3), "one");
  }
  send(port, "while away");
  const FileDescriptor second = open_terminal(port.address());
  EXPECT_EQ(get(second, 10), "while away");
  put(second, "two");
  EXPECT_EQ(poll_port(port, 3), "two");
}

TEST(HostPty, TakesFromTheClientOnlyWhatThereIsRoomFor) {
  HostPort port{open_host_channel("pty")};
  const FileDescriptor client = open_terminal(port.address());
  put(client, "0123456789");
  std::vector<std::uint8_t> in;
  port.exchange(Cycles{}, 0, in);
  EXPECT_TRUE(in.empty());
  EXPECT_EQ(poll_port(port, 4, 4), "0123");
  EXPECT_EQ(poll_port(port, 6), "456789");
}

TEST(HostPty, ALinkLeadsToItAndGoesWithIt) {
  const TempFolder folder;
  const fs::path link = folder.path() / "arm";
  {
    HostPort port{open_host_channel("pty:" + link.string())};
    EXPECT_THAT(port.address(), HasSubstr(link.string()));
    const FileDescriptor client = open_terminal(link);
    put(client, "x");
    EXPECT_EQ(poll_port(port, 1), "x");
  }
  EXPECT_FALSE(fs::exists(fs::symlink_status(link)));
}

TEST(HostPty, ReplacesALinkThatIsLeftOverButNothingElse) {
  const TempFolder folder;
  const fs::path link = folder.path() / "arm";
  fs::create_symlink("/dev/pts/99999", link);
  EXPECT_NO_THROW(HostPort{open_host_channel("pty:" + link.string())});
  folder.write("file", "precious");
  fs::create_symlink("file", link);
  for (const fs::path& taken : {link, folder.path() / "file"}) {
    EXPECT_THROW((void)open_host_channel("pty:" + taken.string()), InputError);
  }
  EXPECT_EQ(test::read_file(link), "precious");
}

TEST(HostPty, LeavesTheLinkOfARunThatGoesOnAlone) {
  const TempFolder folder;
  const std::string where = "pty:" + (folder.path() / "arm").string();
  HostPort first{open_host_channel(where)};
  EXPECT_THROW((void)open_host_channel(where), InputError);
  const FileDescriptor client = open_terminal(folder.path() / "arm");
  put(client, "x");
  EXPECT_EQ(poll_port(first, 1), "x");
}

TEST(HostPty, AClientThatDoesNotReadLosesNoByteSilently) {
  HostPort port{open_host_channel("pty")};
  const FileDescriptor client = open_terminal(port.address());
  const std::size_t total = 4 * HostPort::kBufferBytes;
  std::string all;
  for (std::size_t i = 0; i < total; ++i) all += static_cast<char>('a' + i % 23);
  for (std::size_t i = 0; i < total; i += 512) send(port, all.substr(i, 512));
  EXPECT_GT(port.lost(), 0u);
  // What is not counted as lost is there.
  const std::size_t kept = total - port.lost();
  std::string got;
  std::vector<std::uint8_t> in;
  while (got.size() < kept) {
    const std::string piece = get(client, std::min<std::size_t>(kept - got.size(), 1'024));
    if (piece.empty()) break;
    got += piece;
    port.exchange(Cycles{}, 0, in);
  }
  EXPECT_EQ(got.size(), kept);
  EXPECT_EQ(got.substr(0, HostPort::kBufferBytes), all.substr(0, HostPort::kBufferBytes));
  send(port, "alive");
  EXPECT_EQ(get(client, 5), "alive");
}

TEST(HostPty, CountsAtTheEndWhatNobodyHasFetched) {
  HostPort port{open_host_channel("pty")};
  send(port, "nobody");
  const FileDescriptor client = open_terminal(port.address());
  pollfd arrived{.fd = client.get(), .events = POLLIN, .revents = 0};
  ASSERT_EQ(poll(&arrived, 1, kPatienceMs), 1);
  EXPECT_EQ(port.finish(), 6u);
}

TEST(HostPty, AtTheEndAClientThatReadsGetsEverything) {
  HostPort port{open_host_channel("pty")};
  const FileDescriptor client = open_terminal(port.address());
  for (const char c : std::string("the end")) port.send(static_cast<std::uint8_t>(c));
  std::string got;
  std::thread reader{[&] { got = get(client, 7); }};
  const std::size_t missing = port.finish();
  reader.join();
  EXPECT_EQ(missing, 0u);
  EXPECT_EQ(got, "the end");
}

TEST(HostTcp, IsTransparentForEveryByteBothWays) {
  HostPort port{open_host_channel("tcp:0")};
  EXPECT_THAT(port.address(), StartsWith("127.0.0.1:"));
  EXPECT_NE(port.address(), "127.0.0.1:0");
  const FileDescriptor client = admitted_client(port);
  put(client, kEveryByte);
  EXPECT_EQ(poll_port(port, 256), kEveryByte);
  send(port, kEveryByte);
  EXPECT_EQ(get(client, 256), kEveryByte);
}

TEST(HostTcp, KeepsWhatIsSentUntilAClientConnects) {
  HostPort port{open_host_channel("tcp:0")};
  send(port, "early");
  const FileDescriptor client = admitted_client(port);
  send(port, " and late");
  EXPECT_EQ(get(client, 14), "early and late");
}

TEST(HostTcp, AClientMayGoAndAnotherOneIsServed) {
  HostPort port{open_host_channel("tcp:0")};
  for (int i = 0; i < 3; ++i) {
    const FileDescriptor client = admitted_client(port);
    put(client, "hello");
    EXPECT_EQ(poll_port(port, 5), "hello");
    send(port, "bye");
    EXPECT_EQ(get(client, 3), "bye");
  }
}

TEST(HostTcp, ASecondClientIsToldThatTheLineIsBusy) {
  HostPort port{open_host_channel("tcp:0")};
  FileDescriptor first = admitted_client(port);
  const FileDescriptor second = connect_to(port.address());
  put(second, "token " + port.token() + "\n2");
  exchange(port);
  EXPECT_THAT(get(second, 1'000), StartsWith("error busy"));
  put(first, "1");
  EXPECT_EQ(poll_port(port, 1), "1");
  first.close();
  const FileDescriptor third = admitted_client(port);
  put(third, "3");
  EXPECT_EQ(poll_port(port, 1), "3");
}

// A web page can send such bytes to any port of its user's machine.
TEST(HostTcp, AClientWithoutTheTokenReachesNothing) {
  HostPort port{open_host_channel("tcp:0")};
  for (const std::string& text : {std::string{"POST / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n"} + "frame",
                                  std::string{"token 0123456789abcdef0123456789abcdef\nframe"}, std::string{"\n"}}) {
    const FileDescriptor client = connect_to(port.address());
    put(client, text);
    send(port, "for the pendant");
    std::vector<std::uint8_t> in;
    std::string answer;
    for (int ms = 0; ms < 50; ++ms) {
      port.exchange(Cycles{}, 256, in);
      poll(nullptr, 0, 1);
    }
    EXPECT_TRUE(in.empty()) << text;
    EXPECT_THAT(get(client, 1'000), AllOf(StartsWith("error "), Not(HasSubstr("pendant")))) << text;
  }
}

TEST(HostTcp, BytesThatComeWithTheTokenAreOfTheLine) {
  HostPort port{open_host_channel("tcp:0")};
  const FileDescriptor client = connect_to(port.address());
  put(client, "token " + port.token() + "\nhello");
  EXPECT_EQ(poll_port(port, 2, 2), "he");
  EXPECT_EQ(poll_port(port, 3), "llo");
}

TEST(HostTcp, TheLastBytesReachTheClientAfterThePortIsGone) {
  FileDescriptor client;
  {
    HostPort port{open_host_channel("tcp:0")};
    client = admitted_client(port);
    put(client, "unread by the port");
    send(port, "the end");
    EXPECT_EQ(port.finish(), 0u);
  }
  EXPECT_EQ(get(client, 100), "the end");
}

// Closing with unread bytes would reset the connection, and what the client has no room for yet would be lost.
TEST(HostTcp, AFullConnectionIsClosedWithoutLoss) {
  FileDescriptor client;
  std::size_t sent = 0;
  {
    const auto channel = open_tcp(0);
    client = admitted_client(*channel);
    put(client, "unread by the port");
    const std::vector<std::uint8_t> bytes(65'536, 'x');
    for (int full = 0; full < 20;) {
      const std::size_t count = channel->write(bytes);
      sent += count;
      full = count == 0 ? full + 1 : 0;
      if (count == 0) poll(nullptr, 0, 1);
    }
  }
  EXPECT_EQ(get(client, sent).size(), sent);
}

TEST(HostTcp, APortInUseIsRefusedWithItsNumber) {
  const auto first = open_tcp(0);
  const std::string port = first->address().substr(first->address().find(':') + 1);
  try {
    (void)open_host_channel("tcp:" + port);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("tcp:" + port + ": cannot listen"));
  }
}

TEST(HostChannel, RefusesWordsThatNameNoChannel) {
  for (const char* word :
       {"", "pt", "pty:", "tcp", "tcp:", "tcp:65536", "tcp:-1", "tcp:1x", "tcp:localhost:1", "/tmp"}) {
    EXPECT_THROW((void)open_host_channel(word), InputError) << word;
  }
}

}  // namespace
}  // namespace armature::cosim
