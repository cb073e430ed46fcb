// A server with its clients, through real sockets. The client is mostly that in C.
#pragma once

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/time.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "cosim/fabric/fabric_wrapper.hpp"
#include "cosim/fabric/verilated_fabric.hpp"
#include "cosim/serve/client/armature_client.h"
#include "cosim/serve/server.hpp"
#include "tests/cosim/support/temp_folder.hpp"
#include "tests/support/pin_soc.hpp"

namespace armature::cosim::test {

// Counts the clocks of another thread's logic.
class WatchedFabric final : public FabricWrapper {
 public:
  explicit WatchedFabric(std::atomic<std::int64_t>& cycle) : FabricWrapper{make_verilated_fabric()}, cycle_{cycle} {}
  bool run(std::int64_t limit) override {
    const bool changed = inner().run(limit);
    cycle_ = inner().cycle().value();
    return changed;
  }

 private:
  std::atomic<std::int64_t>& cycle_;
};

// A server in a thread of its own, for as long as the object lives.
class Server {
 public:
  explicit Server(const std::string& where, const std::filesystem::path& out = {})
      : listener_{parse_listen_address(where)},
        interpreter_{soc_, out.empty() ? WaveFolder{} : WaveFolder{out}},
        thread_{[this] { clients_ = serve(listener_, interpreter_, [this] { return stop_.load(); }); }} {}
  ~Server() { stop(); }

  // Ends the server; the number of its clients.
  std::int64_t stop() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    return clients_;
  }

  [[nodiscard]] std::string name() const { return listener_.name(); }
  [[nodiscard]] const char* token() const { return listener_.token() ? listener_.token()->c_str() : nullptr; }
  [[nodiscard]] std::int64_t cycle() const { return cycle_; }
  void wait_for_cycle(std::int64_t cycle) const {
    while (cycle_ < cycle) std::this_thread::yield();
  }
  // For at most a minute; the longest run takes more. A machine that is very busy may look as if it stood still.
  void wait_until_no_clocks_pass() const {
    std::int64_t before = -1, now = cycle();
    for (int i = 0; i < 240 && before != now; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds{250});
      before = std::exchange(now, cycle());
    }
  }

 private:
  std::atomic<bool> stop_{false};
  std::atomic<std::int64_t> cycle_{0};
  Listener listener_;
  ServedSoc soc_{pin_soc(std::make_unique<WatchedFabric>(cycle_))};
  Interpreter interpreter_;
  std::int64_t clients_ = 0;
  std::thread thread_;
};

struct NotYet {};

class Client {
 public:
  explicit Client(const Server& server) {
    EXPECT_EQ(armature_open_with_token(client_.get(), server.name().c_str(), server.token()), ARMATURE_OK)
        << client_->error;
    be_patient();
  }
  // Connected, and has said nothing.
  Client(const Server& server, NotYet) {
    EXPECT_EQ(armature_connect_(client_.get(), server.name().c_str()), ARMATURE_OK) << client_->error;
    be_patient();
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
  // A server that says nothing fails the test instead of blocking it.
  void be_patient() {
    const timeval patience{.tv_sec = 60, .tv_usec = 0};
    setsockopt(client_->socket, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  }

  std::unique_ptr<armature_client> client_ = std::make_unique<armature_client>();
};

class ServeServer : public testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] std::string where() const {
    return std::string{GetParam()} == "tcp" ? "tcp:0" : (folder.path() / "s").string();
  }
  TempFolder folder;
};

inline std::string name_of_socket(const testing::TestParamInfo<const char*>& which) {
  return which.param;
}

}  // namespace armature::cosim::test
