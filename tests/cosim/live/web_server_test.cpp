// Who gets the page and its socket, and what happens to the bytes of others.
#include "cosim/live/web_server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "cosim/net/web_admission.hpp"
#include "tests/cosim/live/web_client.hpp"

namespace armature::cosim {
namespace {

using test::WebClient;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

// Says what happened, and answers with the message itself.
class Echo final : public WebApplication {
 public:
  std::string page() override { return "<p>the page</p>"; }
  std::string on_opened() override {
    ++opened;
    return "welcome";
  }
  void on_closed() override { ++closed; }
  std::string on_message(std::string_view text) override {
    messages.emplace_back(text);
    return "got " + std::to_string(text.size());
  }

  int opened = 0, closed = 0;
  std::vector<std::string> messages;
};

class LiveServer : public testing::Test {
 public:
  std::string token() const { return *listener.token(); }
  std::uint16_t port() const { return *listener.tcp_port(); }
  std::string host() const { return "127.0.0.1:" + std::to_string(port()); }
  WebClient client() { return WebClient{server, port()}; }

  std::string get(const std::string& target, const std::string& headers) {
    WebClient one = client();
    one.send("GET " + target + " HTTP/1.1\r\n" + headers + "\r\n");
    return one.read_all();
  }
  std::string upgrade(const std::string& target, const std::string& origin) const {
    return "GET " + target + " HTTP/1.1\r\nHost: " + host() +
           "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
           "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
           (origin.empty() ? std::string{} : "Origin: " + origin + "\r\n") + "\r\n";
  }
  // With the page's socket open and its first message read.
  std::unique_ptr<WebClient> open_page() {
    auto page = std::make_unique<WebClient>(server, port());
    page->send(upgrade("/" + token() + "/socket", "http://" + host()));
    EXPECT_THAT(page->read_head(), AllOf(StartsWith("HTTP/1.1 101"), HasSubstr("s3pPLMBiTxaQ9kYGzzhZRbK+xOo=")));
    EXPECT_EQ(page->next_message(), "welcome");
    return page;
  }

  Listener listener{ListenAddress{.tcp_port = 0, .path = {}}};
  Echo application;
  WebServer server{listener, application};
};

TEST_F(LiveServer, ThePageNeedsTheToken) {
  const std::string good = "Host: " + host() + "\r\n";
  const std::string page = get("/" + token() + "/", good);
  EXPECT_THAT(page, AllOf(StartsWith("HTTP/1.1 200"), HasSubstr("<p>the page</p>"), HasSubstr("X-Frame-Options: DENY"),
                          HasSubstr("Referrer-Policy: no-referrer"), HasSubstr("Cache-Control: no-store")));
  for (const std::string& target : {std::string{"/"}, "/" + token(), "/x" + token() + "/", std::string{"/socket"}}) {
    EXPECT_THAT(get(target, good), AllOf(StartsWith("HTTP/1.1 403"), HasSubstr("the token is missing or wrong"),
                                         testing::Not(HasSubstr("the page"))))
        << target;
  }
  EXPECT_THAT(get("/" + token() + "/other", good), StartsWith("HTTP/1.1 404"));
}

TEST_F(LiveServer, AnotherHostOrOriginGetsNothing) {
  EXPECT_THAT(get("/" + token() + "/", "Host: evil.example\r\n"), StartsWith("HTTP/1.1 403"));
  EXPECT_THAT(get("/" + token() + "/", "X: y\r\n"), StartsWith("HTTP/1.1 403"));
  for (const char* origin : {"http://evil.example", "null", ""}) {
    WebClient one = client();
    one.send(upgrade("/" + token() + "/socket", origin));
    EXPECT_THAT(one.read_all(), StartsWith("HTTP/1.1 403")) << origin;
  }
  WebClient one = client();
  one.send(upgrade("/socket", "http://" + host()));
  EXPECT_THAT(one.read_all(), StartsWith("HTTP/1.1 403"));
  EXPECT_EQ(application.opened, 0);
}

TEST_F(LiveServer, MessagesAreAnsweredInTheirOrderEvenLongOnes) {
  const auto page = open_page();
  const std::string long_text(300'000, 'x');
  page->send(WebClient::frame("a") + WebClient::frame("bc"));
  EXPECT_EQ(page->next_message(), "got 1");
  EXPECT_EQ(page->next_message(), "got 2");
  const std::string bytes = WebClient::frame(long_text);
  for (std::size_t at = 0; at < bytes.size(); at += 10'000) {
    page->send(std::string_view{bytes}.substr(at, 10'000));
    server.handle(std::chrono::milliseconds{1});
  }
  EXPECT_EQ(page->next_message(), "got 300000");
  EXPECT_EQ(application.messages.back(), long_text);
}

TEST_F(LiveServer, ASecondPageIsToldThatTheArmIsTakenUntilTheFirstIsClosed) {
  auto first = open_page();
  WebClient second = client();
  second.send(upgrade("/" + token() + "/socket", "http://" + host()));
  EXPECT_THAT(second.read_head(), StartsWith("HTTP/1.1 101"));
  EXPECT_EQ(second.next_message(), R"({"busy":"another page has the arm; one page at a time"})");
  EXPECT_EQ(second.next_message(), "close another page has the arm; one page at a time");
  second.send(WebClient::frame("x"));
  first->send(WebClient::frame("still here"));
  EXPECT_EQ(first->next_message(), "got 10");
  EXPECT_THAT(application.messages, testing::ElementsAre("still here")) << "a refused page commands nothing";
  EXPECT_EQ(application.opened, 1);
  first->close();
  ASSERT_TRUE(second.wait_until([this] { return application.closed == 1; }));
  EXPECT_FALSE(server.has_page());
  open_page();
}

TEST_F(LiveServer, BrokenBytesEndTheirConnectionOnly) {
  const auto page = open_page();
  for (const std::string& bytes :
       {std::string{"\x16\x03\x01 TLS"}, std::string{"GET\r\n\r\n"}, std::string(100'000, 'A'),
        "GET / HTTP/1.1\r\n" + std::string(50'000, 'h') + ": x\r\n\r\n"}) {
    WebClient one = client();
    one.send(bytes);
    EXPECT_THAT(one.read_all(), testing::AnyOf("", StartsWith("HTTP/1.1 400")));
  }
  page->send(WebClient::frame("here"));
  EXPECT_EQ(page->next_message(), "got 4");
}

TEST_F(LiveServer, AFrameThatNoBrowserSendsClosesThePage) {
  const auto page = open_page();
  page->send("\x81\x01x");  // without a mask
  page->read_all();
  page->close();
  EXPECT_TRUE(page->wait_until([this] { return application.closed == 1; }));
  EXPECT_TRUE(application.messages.empty());
}

TEST_F(LiveServer, AMessageBeyondTheLimitClosesThePage) {
  const auto page = open_page();
  std::string head = WebClient::frame(std::string(WebServer::kMaxMessage + 1, 'x')).substr(0, 5'000);
  page->send(head);
  page->read_all();
  page->close();
  EXPECT_TRUE(page->wait_until([this] { return application.closed == 1; }));
}

TEST_F(LiveServer, APageThatDoesNotReadGetsFewerMessages) {
  const auto page = open_page();
  const std::string state(10'000, 's');
  for (int i = 0; i < 2'000; ++i) {  // 20 MB: more than the buffers of the system hold
    server.offer(state);
    server.handle(std::chrono::milliseconds{0});
  }
  EXPECT_TRUE(server.has_page());
  int received = 0;
  page->send(WebClient::frame("ping"));
  for (std::optional<std::string> text = page->next_message(); text && *text != "got 4"; text = page->next_message()) {
    EXPECT_EQ(text->size(), state.size());
    ++received;
  }
  EXPECT_GT(received, 0);
  EXPECT_LT(received, 2'000);
}

TEST_F(LiveServer, ConnectionsThatSayNothingDoNotKeepOthersOut) {
  std::vector<std::unique_ptr<WebClient>> silent;
  for (int i = 0; i < 20; ++i) silent.push_back(std::make_unique<WebClient>(server, port()));
  EXPECT_THAT(get("/" + token() + "/", "Host: " + host() + "\r\n"), StartsWith("HTTP/1.1 200"));
  open_page();
}

}  // namespace
}  // namespace armature::cosim
