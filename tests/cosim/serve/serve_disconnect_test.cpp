// Clients that go, and what becomes of their work.
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <memory>
#include <string>

#include "cosim/net/waiting_clients.hpp"
#include "tests/cosim/support/serve_server.hpp"

namespace armature::cosim {
namespace {

using test::Client;
using test::NotYet;
using test::Server;

class ServeDisconnect : public test::ServeServer {};

TEST_P(ServeDisconnect, AClientThatGoesInTheMiddleOfALineFreesIt) {
  Server server{where()};
  {
    Client client{server};
    client.send_text("run 1");
  }
  Client next{server};
  std::uint64_t cycle = 1;
  EXPECT_EQ(armature_time(next, &cycle), ARMATURE_OK);
  EXPECT_EQ(cycle, 0u);
}

// How a client goes while its run is under way, and whether another one comes.
void expect_the_run_to_end(Server& server, bool reset, bool until_irq, bool another_comes) {
  {
    Client client{server};
    client.send_text(until_irq ? "run-until-irq 1000000000\nrun 1000000000\n" : "run 1000000000\nrun 1000000000\n");
    server.wait_for_cycle(server.cycle() + 1);
    const linger at_once{.l_onoff = 1, .l_linger = 0};
    if (reset) setsockopt(client->socket, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  }
  if (!another_comes) server.wait_until_no_clocks_pass();
  const std::int64_t last = server.cycle();
  Client next{server};
  std::uint64_t cycle = 0;
  EXPECT_EQ(armature_time(next, &cycle), ARMATURE_OK);
  EXPECT_LT(cycle, 500'000'000u);
  if (!another_comes) {
    EXPECT_EQ(cycle, static_cast<std::uint64_t>(last)) << "it had ended before another one came";
  }
}

TEST_P(ServeDisconnect, ARunForAClientThatHasGoneEnds) {
  Server server{where()};
  expect_the_run_to_end(server, false, false, false);
}

TEST_P(ServeDisconnect, AnotherClientIsServedInsteadOfARunForOneThatHasGone) {
  for (const bool until_irq : {false, true}) {
    for (const bool reset : {false, true}) {
      Server server{where()};
      expect_the_run_to_end(server, reset, until_irq, true);
    }
  }
}

TEST_P(ServeDisconnect, ARunForAClientThatOnlySendsNoMoreGoesOn) {
  Server server{where()};
  Client client{server};
  client.send_text("run 1000000\ntime\n");
  shutdown(client->socket, SHUT_WR);
  server.wait_for_cycle(1);
  {
    Client other{server, NotYet{}};
    EXPECT_EQ(other.receive_all(), kBusy);
  }
  EXPECT_EQ(client.receive_all(), "ok 1000000\nok 1000000\n");
}

TEST_P(ServeDisconnect, OutlivesAClientThatGoesWithoutReading) {
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

INSTANTIATE_TEST_SUITE_P(Over, ServeDisconnect, testing::Values("tcp", "path"), test::name_of_socket);

}  // namespace
}  // namespace armature::cosim
