// The run that is debugged, as the protocol sees it: it lives in a process of its own (debugged_run.hpp).
#pragma once

#include <sys/types.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "cosim/iss/debug/debugged_run.hpp"
#include "cosim/iss/debug/protocol/target.hpp"
#include "cosim/iss/debug/run_messages.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/snapshot/message_channel.hpp"

namespace armature::cosim::iss {

class RemoteRun final : public Target {
 public:
  // Before its first instruction. Throws std::runtime_error when the process cannot be made.
  RemoteRun(const Scenario& scenario, const DebuggedRunOptions& options);
  RemoteRun(const RemoteRun&) = delete;
  RemoteRun& operator=(const RemoteRun&) = delete;
  // Ends the run.
  ~RemoteRun() override;

  // Readable when the run has something to tell: then hear() does not wait.
  [[nodiscard]] int descriptor() const { return channel_.descriptor(); }
  // What the run that continues tells next. Nothing: a part of end_text().
  [[nodiscard]] std::optional<Stop> hear();
  // Of a run that has ended: what a command prints of it, or why it cannot continue.
  [[nodiscard]] const std::string& end_text() const { return end_text_; }

  // Target
  Registers registers(int core) override;
  bool write_register(int core, int number, std::uint64_t value) override;
  std::vector<std::uint8_t> read_memory(std::uint32_t address, std::uint32_t bytes) override;
  bool write_memory(std::uint32_t address, std::span<const std::uint8_t> bytes) override;
  std::string state(int core) override;
  std::string monitor(std::string_view command) override;
  void resume(const Resume& how, std::span<const StopPoint> points) override;
  void detach() override;
  void interrupt() override;

 private:
  DebugAnswer ask(const DebugRequest& request);
  void search(std::int64_t end);
  void go_back(std::int64_t position, const Stop& stop);
  void continue_search(const DebugAnswer& found);
  void tell(const DebugRequest& request) { channel_.send(request); }

  MessageChannel channel_;
  pid_t process_ = 0;
  std::string end_text_;
  bool ended_ = false;
  std::int64_t position_ = 0;  // where the run stands
  std::array<std::int64_t, 2> before_{};
  Continuation wanted_;       // of a search backwards
  bool search_ends_ = false;  // it was interrupted
};

}  // namespace armature::cosim::iss
