// The server through real sockets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/time.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "tests/cosim/support/serve_server.hpp"

namespace armature::cosim {
namespace {

using test::Client;
using test::Server;
using test::ServeServer;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

TEST_P(ServeServer, CarriesOutTheCallsOfTheClient) {
  Server server{where(), folder.path()};
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
  EXPECT_EQ(armature_vcd(client, "a.vcd"), ARMATURE_OK);
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

TEST_P(ServeServer, RefusesALineThatIsTooLongAndGoesOn) {
  Server server{where()};
  Client client{server};
  client.send_text(std::string(Interpreter::kMaxLine + 1, 'r') + "\n" + "time" +
                   std::string(Interpreter::kMaxLine - 4, ' ') + "\n");
  shutdown(client->socket, SHUT_WR);
  EXPECT_EQ(client.receive_all(), "error a line has at most 4096 bytes, a batch 131072\nok 0\n");
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
  server.wait_for_cycle(2);
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

INSTANTIATE_TEST_SUITE_P(Over, ServeServer, testing::Values("tcp", "path"), test::name_of_socket);

}  // namespace
}  // namespace armature::cosim
