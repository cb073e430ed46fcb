// Who is served: one client at a time, and over TCP only who knows the token.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cosim/net/waiting_clients.hpp"
#include "tests/cosim/support/serve_server.hpp"

namespace armature::cosim {
namespace {

using test::Client;
using test::NotYet;
using test::Server;
using testing::HasSubstr;
using testing::StartsWith;

class ServeAdmission : public test::ServeServer {};

TEST_P(ServeAdmission, TheNextClientFindsTheLogicAsItWasLeft) {
  Server server{where()};
  auto first = std::make_unique<Client>(server);
  EXPECT_EQ(armature_set_pin(*first, "home_i", 9), ARMATURE_OK);
  EXPECT_EQ(armature_run(*first, 1234, nullptr), ARMATURE_OK);
  first.reset();
  Client second{server};
  second.send_text("time\npin home_i\n");
  shutdown(second->socket, SHUT_WR);
  EXPECT_EQ(second.receive_all(), "ok 1234\nok 0x9\n");
  EXPECT_EQ(server.stop(), 2);
}

TEST_P(ServeAdmission, ASecondClientIsToldAtOnceThatTheServerIsBusy) {
  Server server{where()};
  Client first{server};
  {
    Client second{server, NotYet{}};
    EXPECT_EQ(second.receive_all(), kBusy) << "also when it says nothing";
  }
  const auto third = std::make_unique<armature_client>();
  EXPECT_EQ(armature_open_with_token(third.get(), server.name().c_str(), server.token()), ARMATURE_LOST);
  EXPECT_STREQ(third->error, "busy: another client is served, one at a time; closed");
  EXPECT_EQ(third->socket, -1);
  EXPECT_EQ(armature_run(first, 5, nullptr), ARMATURE_OK) << "the first continues";
  EXPECT_EQ(server.stop(), 1);
}

TEST_P(ServeAdmission, ASecondClientIsToldDuringALongRun) {
  Server server{where()};
  Client first{server};
  first.send_text("run 1000000000\n");
  server.wait_for_cycle(1);
  Client second{server, NotYet{}};
  EXPECT_EQ(second.receive_all(), kBusy);
  server.stop();
  EXPECT_THAT(first.receive_all(), StartsWith("error interrupted at cycle "));
}

TEST_P(ServeAdmission, ClientsOneAfterTheOtherNeverFindItBusy) {
  Server server{where()};
  for (int i = 0; i < 300; ++i) {
    Client client{server};
    if (i % 3 == 0) {
      ASSERT_EQ(armature_time(client, nullptr), ARMATURE_OK);
    }
    if (i % 3 == 1) client.send_text("time\ntime\ntime\nti");  // and goes without reading
  }
  EXPECT_EQ(server.stop(), 300);
}

TEST_P(ServeAdmission, TakesTheTokenLineWhetherItIsNeededOrNot) {
  Server server{where()};
  Client client{server, NotYet{}};
  client.send_text("token " + std::string{server.token() == nullptr ? "none" : server.token()} + "\r\nrun 3\n");
  shutdown(client->socket, SHUT_WR);
  EXPECT_EQ(client.receive_all(), "ok\nok 3\n");
}

// What a page in the user's browser can make it send.
TEST(ServeAdmissionByToken, NothingOfAnHttpRequestIsCarriedOut) {
  const test::TempFolder folder;
  Server server{"tcp:0", folder.path()};
  const std::string body = "vcd x.vcd\nrun 100\nvcd\ntoken " + std::string{server.token()} + "\nrun 100\n";
  for (const std::string& request :
       {"POST / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body,
        body, "\n" + body, "token x\n" + body, "token\n" + body, std::string(5000, 'x') + "\n" + body}) {
    Client client{server, NotYet{}};
    client.send_text(request);
    const std::string answer = client.receive_all();
    EXPECT_THAT(answer, StartsWith("error "));
    EXPECT_THAT(answer, HasSubstr("the first line must be 'token TOKEN'"));
    EXPECT_EQ(std::ranges::count(answer, '\n'), 1) << answer;
  }
  Client client{server};
  std::uint64_t cycle = 1;
  EXPECT_EQ(armature_time(client, &cycle), ARMATURE_OK);
  EXPECT_EQ(cycle, 0u);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_EQ(server.stop(), 1) << "the others were no clients";
}

TEST(ServeAdmissionByToken, ClientsWithoutItKeepNobodyOut) {
  Server server{"tcp:0"};
  std::vector<std::unique_ptr<Client>> silent;
  // More than wait at a time: those that have waited longest are refused.
  for (int i = 0; i < 40; ++i) silent.push_back(std::make_unique<Client>(server, NotYet{}));
  EXPECT_THAT(silent.front()->receive_all(), StartsWith("error the first line must be"));
  Client client{server};
  EXPECT_EQ(armature_time(client, nullptr), ARMATURE_OK);
  EXPECT_EQ(silent.back()->receive_all(), kBusy);
}

TEST(ServeAdmissionByToken, IsTakenInPieces) {
  Server server{"tcp:0"};
  Client client{server, NotYet{}};
  for (const char c : "token " + std::string{server.token()} + "\nrun 3\n") client.send_text(std::string(1, c));
  shutdown(client->socket, SHUT_WR);
  EXPECT_EQ(client.receive_all(), "ok\nok 3\n");
}

TEST(ServeClient, SaysWhyTheServerDidNotTakeIt) {
  Server server{"tcp:0"};
  const auto client = std::make_unique<armature_client>();
  for (const char* wrong : {"", "0123456789abcdef0123456789abcdef"}) {
    EXPECT_EQ(armature_open_with_token(client.get(), server.name().c_str(), wrong), ARMATURE_LOST);
    EXPECT_THAT(client->error, StartsWith("wrong token: ")) << wrong;
  }
  for (const std::string& wrong : {std::string{"a\ntime"}, std::string(5000, 'a')}) {
    EXPECT_EQ(armature_open_with_token(client.get(), server.name().c_str(), wrong.c_str()), ARMATURE_LOST);
    EXPECT_STREQ(client->error, "the token must be one word");
  }
}

TEST(ServeClient, TakesTheTokenFromTheEnvironment) {
  Server server{"tcp:0"};
  const auto client = std::make_unique<armature_client>();
  setenv("ARMATURE_TOKEN", server.token(), 1);
  EXPECT_EQ(armature_open(client.get(), server.name().c_str()), ARMATURE_OK) << client->error;
  EXPECT_EQ(armature_time(client.get(), nullptr), ARMATURE_OK);
  armature_close(client.get());
  unsetenv("ARMATURE_TOKEN");
  EXPECT_EQ(armature_open(client.get(), server.name().c_str()), ARMATURE_LOST);
}

INSTANTIATE_TEST_SUITE_P(Over, ServeAdmission, testing::Values("tcp", "path"), test::name_of_socket);

}  // namespace
}  // namespace armature::cosim
