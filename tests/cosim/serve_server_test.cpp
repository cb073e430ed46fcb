// The server through real sockets, mostly with the C client.
#include "cosim/serve/server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/time.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "cosim/fabric/verilated_fabric.hpp"
#include "cosim/serve/client/armature_client.h"
#include "tests/cosim/temp_folder.hpp"

namespace armature::cosim {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

// A server in a thread of its own, for as long as the object lives.
class Server {
 public:
  explicit Server(const std::string& where) : listener_{parse_listen_address(where)} {}
  ~Server() { stop(); }

  // Ends the server; the number of its clients.
  std::int64_t stop() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    return clients_;
  }

  [[nodiscard]] std::string name() const { return listener_.name(); }
  // Only a long run asks whether it shall stop.
  void wait_for_a_long_run() const {
    while (!in_long_run_) std::this_thread::yield();
  }

 private:
  std::atomic<bool> stop_{false};
  std::atomic<bool> in_long_run_{false};
  Listener listener_;
  ServedSoc soc_{make_verilated_fabric(), {}, [this] {
                   in_long_run_ = true;
                   return stop_.load();
                 }};
  Interpreter interpreter_{soc_};
  std::int64_t clients_ = 0;
  std::thread thread_{[this] { clients_ = serve(listener_, interpreter_, [this] { return stop_.load(); }); }};
};

class Client {
 public:
  explicit Client(const Server& server) {
    EXPECT_EQ(armature_open(client_.get(), server.name().c_str()), ARMATURE_OK) << client_->error;
  }
  ~Client() { armature_close(client_.get()); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  armature_client* operator->() { return client_.get(); }
  operator armature_client*() { return client_.get(); }

  // Everything until the server closes the connection.
  std::string receive_all() {
    std::string all;
    char bytes[4096];
    for (ssize_t n; (n = recv(client_->socket, bytes, sizeof bytes, 0)) > 0;) all.append(bytes, static_cast<size_t>(n));
    return all;
  }
  void send_text(const std::string& text) {
    EXPECT_EQ(send(client_->socket, text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
  }

 private:
  std::unique_ptr<armature_client> client_ = std::make_unique<armature_client>();
};

class ServeServer : public testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] std::string where() const {
    return std::string{GetParam()} == "tcp" ? "tcp:0" : (folder.path() / "s").string();
  }
  test::TempFolder folder;
};

TEST_P(ServeServer, CarriesOutTheCallsOfTheClient) {
  Server server{where()};
  Client client{server};
  std::uint32_t value = 0;
  std::uint64_t cycle = 0;
  EXPECT_EQ(armature_write(client, 0x42800004, 2498), ARMATURE_OK);
  EXPECT_EQ(armature_read(client, 0x42800004, &value), ARMATURE_OK);
  EXPECT_EQ(value, 2498u);
  EXPECT_EQ(armature_write_bytes(client, 0x43C20080, 0x00FFFFFF, 1), ARMATURE_OK);
  EXPECT_EQ(armature_read(client, 0x43C20080, &value), ARMATURE_OK);
  EXPECT_EQ(value, 0x0027FFu) << "10000 with its lowest byte changed";
  EXPECT_EQ(armature_set_pin(client, "home_i", 5), ARMATURE_OK);
  EXPECT_EQ(armature_get_pin(client, "home_i", &value), ARMATURE_OK);
  EXPECT_EQ(value, 5u);
  EXPECT_EQ(armature_time(client, &cycle), ARMATURE_OK);
  EXPECT_EQ(cycle, 2u * 19 + 2 * 18);
  EXPECT_EQ(armature_run(client, 26, &cycle), ARMATURE_OK);
  EXPECT_EQ(cycle, 100u);
  EXPECT_EQ(armature_run_until_irq(client, 10, &cycle), ARMATURE_REFUSED);
  EXPECT_STREQ(client->error, "no interrupt within 10 cycles");
  EXPECT_EQ(armature_read(client, 0, &value), ARMATURE_REFUSED);
  EXPECT_THAT(client->error, StartsWith("DECERR"));
  EXPECT_EQ(armature_vcd(client, (folder.path() / "a.vcd").c_str()), ARMATURE_OK);
  EXPECT_EQ(armature_vcd(client, nullptr), ARMATURE_OK);
  EXPECT_EQ(armature_answer(client, nullptr), ARMATURE_REFUSED) << "nothing is in flight";
}

TEST_P(ServeServer, TakesItsShareOfCommandsBeforeAnAnswerIsRead) {
  Server server{where()};
  Client client{server};
  static_assert(kMaxInFlight == ARMATURE_MAX_IN_FLIGHT && Interpreter::kMaxAnswer == ARMATURE_MAX_ANSWER);
  // A server that has stopped reading fails the test instead of blocking it.
  const timeval patience{.tv_sec = 10, .tv_usec = 0};
  setsockopt(client->socket, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  for (unsigned round = 0; round < 3; ++round) {
    for (unsigned i = 0; i < ARMATURE_MAX_IN_FLIGHT; ++i) {
      // Some with the longest answer; all too long for the buffers of the system to hold the commands of a round.
      ASSERT_EQ(armature_post(client, "%s%1000s", i % 3 == 0 ? "help pin" : "run 1", ""), ARMATURE_OK);
    }
    EXPECT_EQ(armature_post(client, "run 1"), ARMATURE_REFUSED) << "one too many";
    std::uint64_t cycle = 0;
    for (unsigned i = 0; i < ARMATURE_MAX_IN_FLIGHT; ++i) {
      ASSERT_EQ(armature_answer(client, i % 3 == 0 ? nullptr : &cycle), ARMATURE_OK) << client->error;
      const unsigned runs = ARMATURE_MAX_IN_FLIGHT - (ARMATURE_MAX_IN_FLIGHT + 2) / 3;
      if (i % 3 == 0) continue;
      ASSERT_EQ(cycle, round * runs + i - i / 3) << "in the order of the commands";
    }
  }
}

TEST_P(ServeServer, AnswersAClientThatHasClosedItsSendingSide) {
  Server server{where()};
  Client client{server};
  client.send_text("run 7\ntime\r\nrun 100");
  shutdown(client->socket, SHUT_WR);
  EXPECT_EQ(client.receive_all(), "ok 7\nok 7\n") << "a line without its end is no command";
}

TEST_P(ServeServer, AnswersEverythingToAClientThatReadsAfterClosingItsSendingSide) {
  Server server{where()};
  Client client{server};
  std::string text;
  for (std::size_t i = 0; i < kMaxInFlight; ++i) text += "help pin\n";
  client.send_text(text);
  shutdown(client->socket, SHUT_WR);
  // So that the server sees the end while it still has answers. A right server passes without it too.
  std::this_thread::sleep_for(std::chrono::milliseconds{30});
  const std::string answers = client.receive_all();
  EXPECT_EQ(std::ranges::count(answers, '\n'), static_cast<std::ptrdiff_t>(kMaxInFlight));
  EXPECT_GT(answers.size(), 1'000'000u) << "more than the buffers of the system hold";
}

TEST_P(ServeServer, TheNextClientWaitsAndFindsTheLogicAsItWasLeft) {
  Server server{where()};
  auto first = std::make_unique<Client>(server);
  EXPECT_EQ(armature_run(*first, 1000, nullptr), ARMATURE_OK);
  Client second{server};
  second.send_text("time\npin home_i\n");
  EXPECT_EQ(armature_set_pin(*first, "home_i", 9), ARMATURE_OK);
  EXPECT_EQ(armature_run(*first, 234, nullptr), ARMATURE_OK);
  first.reset();
  shutdown(second->socket, SHUT_WR);
  EXPECT_EQ(second.receive_all(), "ok 1234\nok 0x9\n");
  EXPECT_EQ(server.stop(), 2);
}

TEST_P(ServeServer, OutlivesAClientThatGoesWithoutReading) {
  Server server{where()};
  {
    Client rude{server};
    std::string text;
    for (int i = 0; i < 2000; ++i) text += "help pin\n";
    rude.send_text(text);
  }
  { Client empty{server}; }
  Client client{server};
  std::uint64_t cycle = 1;
  EXPECT_EQ(armature_time(client, &cycle), ARMATURE_OK);
  EXPECT_EQ(cycle, 0u);
}

TEST_P(ServeServer, RefusesALineThatIsTooLongAndGoesOn) {
  Server server{where()};
  Client client{server};
  client.send_text(std::string(Interpreter::kMaxLine + 1, 'r') + "\n" + "time" +
                   std::string(Interpreter::kMaxLine - 4, ' ') + "\n");
  shutdown(client->socket, SHUT_WR);
  EXPECT_EQ(client.receive_all(), "error a line has at most 4096 bytes\nok 0\n");
}

TEST_P(ServeServer, EndsWhileAClientIsConnected) {
  Server server{where()};
  Client idle{server};
  EXPECT_EQ(armature_time(idle, nullptr), ARMATURE_OK);
  EXPECT_EQ(server.stop(), 1);
  EXPECT_EQ(armature_time(idle, nullptr), ARMATURE_LOST);
}

TEST_P(ServeServer, EndsInTheMiddleOfALongRun) {
  Server server{where()};
  Client client{server};
  EXPECT_EQ(armature_time(client, nullptr), ARMATURE_OK);
  client.send_text("run 1\nrun 1000000000\n");
  server.wait_for_a_long_run();
  server.stop();
  EXPECT_THAT(client.receive_all(), testing::AllOf(StartsWith("ok 1\nerror interrupted at cycle "), EndsWith("\n")));
}

TEST_P(ServeServer, DoesNotKeepTheAnswerToALongRunBackForTheNext) {
  Server server{where()};
  Client client{server};
  EXPECT_EQ(armature_post(client, "run 60000"), ARMATURE_OK);
  EXPECT_EQ(armature_post(client, "run 1000000000"), ARMATURE_OK);
  std::uint64_t cycle = 0;
  EXPECT_EQ(armature_answer(client, &cycle), ARMATURE_OK);
  EXPECT_EQ(cycle, 60000u);
  server.stop();
}

TEST(ServeClient, RefusesWhatIsNoLineOrNoServer) {
  Server server{"tcp:0"};
  Client client{server};
  EXPECT_EQ(armature_post(client, "time\ntime"), ARMATURE_REFUSED);
  EXPECT_EQ(armature_post(client, "%5000d", 1), ARMATURE_REFUSED);
  EXPECT_EQ(armature_time(client, nullptr), ARMATURE_OK) << "nothing of it was queued";

  auto lost = std::make_unique<armature_client>();
  for (const char* where : {"tcp:", "tcp:0", "tcp:x", "tcp:70000", "/nonexistent/s"}) {
    EXPECT_EQ(armature_open(lost.get(), where), ARMATURE_LOST) << where;
    EXPECT_STRNE(lost->error, "") << where;
  }
  EXPECT_EQ(armature_open(lost.get(), std::string(200, 'a').c_str()), ARMATURE_LOST);
  EXPECT_THAT(lost->error, HasSubstr("too long"));
}

INSTANTIATE_TEST_SUITE_P(Over, ServeServer, testing::Values("tcp", "path"),
                         [](const auto& which) { return std::string{which.param}; });

}  // namespace
}  // namespace armature::cosim
