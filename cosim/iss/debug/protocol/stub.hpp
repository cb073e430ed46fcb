// gdb's remote serial protocol: the answer to each packet. It knows no socket, and of the run what Target says.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/iss/debug/protocol/target.hpp"

namespace armature::cosim::iss {

class Stub {
 public:
  // The target must outlive the stub. `stop`: where the run stands.
  Stub(Target& target, const Stop& stop) : target_{target}, stop_{stop} {}

  // The answer to the payload of a packet. Nothing: gdb gets none now, because the run continues until stopped(), or
  // because gdb has gone.
  [[nodiscard]] std::optional<std::string> answer(std::string_view packet);
  // Ctrl-C of gdb.
  void interrupt() {
    if (runs_) target_.interrupt();
  }
  // The run has stopped. The answer for the packet that has continued it.
  [[nodiscard]] std::string stopped(const Stop& stop);

  [[nodiscard]] bool runs() const { return runs_; }
  // From the answer to the present packet on, packets are not acknowledged.
  [[nodiscard]] bool acknowledges() const { return acknowledges_; }

  enum class End : std::uint8_t { kNone, kDetached, kKilled };
  // Whether gdb has ended the session.
  [[nodiscard]] End end() const { return end_; }
  // Another gdb has connected: it finds no stop points.
  void begin_session();

 private:
  std::string query(std::string_view packet);
  std::string select(std::string_view packet);
  std::string read_registers();
  std::string write_registers(std::string_view digits);
  std::string read_register(std::string_view number);
  std::string write_register(std::string_view assignment);
  std::string read_memory(std::string_view range);
  std::string write_memory(std::string_view arguments);
  std::string change_point(std::string_view packet);
  std::optional<std::string> resume_by_threads(std::string_view actions);
  std::optional<std::string> resume(const Resume& how);
  std::string monitor(std::string_view digits);
  [[nodiscard]] std::string stop_reply() const;

  Target& target_;
  Stop stop_;
  std::vector<StopPoint> points_;
  int core_ = 0;  // that g, p and so on mean
  bool runs_ = false;
  bool acknowledges_ = true;
  End end_ = End::kNone;
};

}  // namespace armature::cosim::iss
