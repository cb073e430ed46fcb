// Register accesses per second through `armature serve`, and what each layer costs.
//
//   bus          the served logic called directly: the clocks of an access and nothing else
//   protocol     the same with the text of command and answer, no socket
//   pipelined    the C client over a socket with thousands of commands in flight; 50 000 a second are wanted
//   one by one   the C client waiting for each answer
//
// Reads and writes alternate. Server and client are threads of this process; wall-clock time, the best of all rounds.
// usage: serve_bench [ROUNDS]
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "cosim/kernel/scenario_soc.hpp"
#include "cosim/net/listener.hpp"
#include "cosim/serve/client/armature_client.h"
#include "cosim/serve/interpreter.hpp"
#include "cosim/serve/served_soc.hpp"
#include "cosim/serve/server.hpp"

namespace {

using namespace armature::cosim;

constexpr int kAccesses = 200'000;
constexpr int kOneByOne = 20'000;
constexpr std::uint32_t kAddr = 0x42800004;  // TLR0

void require(bool ok, const std::string& what) {
  if (!ok) throw std::runtime_error{what};
}

template <class Work>
double per_second(int accesses, const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return accesses / std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double bus_rate() {
  ServedSoc soc{make_soc(Scenario{})};
  return per_second(kAccesses, [&] {
    for (std::uint32_t i = 0; i < kAccesses; ++i) {
      const auto response = soc.access({.write = i % 2 == 0, .addr = kAddr, .data = i});
      require(response.error == BusError::kNone, "an access was refused");
    }
  });
}

double protocol_rate() {
  ServedSoc soc{make_soc(Scenario{})};
  Interpreter interpreter{soc};
  return per_second(kAccesses, [&] {
    std::string answers;
    for (int i = 0; i < kAccesses; ++i) {
      interpreter.answer(i % 2 == 0 ? fmt::format("w 0x{:X} {}", kAddr, i) : fmt::format("r 0x{:X}", kAddr), answers,
                         [] { return false; });
      if (answers.size() > 65536) answers.clear();
    }
  });
}

class Server {
 public:
  explicit Server(const std::string& where) : listener_{parse_listen_address(where)} {}
  ~Server() {
    stop_ = true;
    thread_.join();
  }
  [[nodiscard]] std::string name() const { return listener_.name(); }
  [[nodiscard]] const char* token() const { return listener_.token() ? listener_.token()->c_str() : nullptr; }

 private:
  std::atomic<bool> stop_{false};
  Listener listener_;
  ServedSoc soc_{make_soc(Scenario{})};
  Interpreter interpreter_{soc_};
  std::thread thread_{[this] { serve(listener_, interpreter_, [this] { return stop_.load(); }); }};
};

double socket_rate(const std::string& where, bool pipelined) {
  const Server server{where};
  const auto client = std::make_unique<armature_client>();
  require(armature_open_with_token(client.get(), server.name().c_str(), server.token()) == ARMATURE_OK, client->error);
  const int accesses = pipelined ? kAccesses : kOneByOne;
  const int in_flight = pipelined ? ARMATURE_MAX_IN_FLIGHT : 1;
  int posted = 0, answered = 0;
  const double rate = per_second(accesses, [&] {
    while (answered < accesses) {
      for (; posted < std::min(accesses, answered + in_flight); ++posted) {
        const int result = posted % 2 == 0 ? armature_post(client.get(), "w 0x%X %d", kAddr, posted)
                                           : armature_post(client.get(), "r 0x%X", kAddr);
        require(result == ARMATURE_OK, client->error);
      }
      // Half of them, so that the server has work while the client writes.
      const int until = posted == accesses ? accesses : posted - in_flight / 2;
      for (; answered < until; ++answered) {
        std::uint64_t value = 0;
        require(armature_answer(client.get(), &value) == ARMATURE_OK, client->error);
        const bool read = answered % 2 == 1;
        require(!read || value + 1 == static_cast<std::uint64_t>(answered), "a wrong value was read");
      }
    }
  });
  armature_close(client.get());
  return rate;
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 5;
  const std::string path =
      (std::filesystem::temp_directory_path() / fmt::format("armature_bench_{}.sock", getpid())).string();
  double bus = 0, protocol = 0, path_many = 0, path_one = 0, tcp_many = 0, tcp_one = 0;
  for (int round = 0; round < rounds; ++round) {
    bus = std::max(bus, bus_rate());
    protocol = std::max(protocol, protocol_rate());
    path_many = std::max(path_many, socket_rate(path, true));
    path_one = std::max(path_one, socket_rate(path, false));
    tcp_many = std::max(tcp_many, socket_rate("tcp:0", true));
    tcp_one = std::max(tcp_one, socket_rate("tcp:0", false));
  }
  fmt::print("register accesses a second, half of them writes, best of {} rounds\n", rounds);
  const auto line = [](const char* name, double rate, const char* note = "") {
    fmt::print("{:<28} {:9.0f}{}\n", name, rate, note);
  };
  line("bus", bus);
  line("protocol", protocol);
  line("Unix socket, pipelined", path_many, "   (at least 50000)");
  line("Unix socket, one by one", path_one);
  line("TCP, pipelined", tcp_many, "   (at least 50000)");
  line("TCP, one by one", tcp_one);
  return 0;
}
