// The protocol of `armature serve`: a line of text in, a line of text out. README.md of this folder describes it.
//
// It uses no socket and no wall clock. Every line, whatever its bytes, gets exactly one answer: printable ASCII of at
// most kMaxAnswer bytes (of a batch kMaxBatchAnswer) that begins with `ok` or `error`. A malformed line has no effect.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "cosim/net/client_channel.hpp"
#include "cosim/serve/command_words.hpp"
#include "cosim/serve/served_soc.hpp"
#include "cosim/serve/wave_folder.hpp"

namespace armature::cosim {

class Interpreter {
 public:
  static constexpr std::size_t kMaxAnswer = 512;                    // the end of the line included
  static constexpr std::size_t kMaxLine = ClientChannel::kMaxLine;  // longer ones are refused
  // Of a batch: its operations, its line, and its answer, with its end.
  static constexpr std::size_t kMaxOperations = 4096;
  static constexpr std::size_t kMaxBatchLine = 32 * kMaxOperations;
  static constexpr std::size_t kMaxBatchAnswer = 20 * kMaxOperations + kMaxAnswer;
  // Limit of one line, 20 s of simulated time, so that a mistyped digit does not block the server for an hour.
  static constexpr std::int64_t kMaxCycles = 1'000'000'000;

  // `waves` is where `vcd FILE` may write.
  explicit Interpreter(ServedSoc& soc, WaveFolder waves = {}) : soc_{soc}, waves_{std::move(waves)} {}

  // Executes one line, given without its end, and appends the answer with its end to `out`. `stop` can end a run early;
  // the answer then reports it.
  void answer(std::string_view line, std::string& out, const StopRequest& stop);

  // Appends the answer to a line that was longer than kMaxBatchLine.
  void answer_to_long_line(std::string& out);

  [[nodiscard]] Cycles now() const { return soc_.now(); }

  // Number of answered lines.
  [[nodiscard]] std::int64_t lines() const { return lines_; }

  // True after an assertion inside the logic has failed: its state is not valid any more. The answer reported it.
  [[nodiscard]] bool broken() const { return broken_; }

 private:
  struct Command;

  static const Command* find(std::string_view name);
  void execute(std::string_view line, std::string& out);
  void execute_operation(std::string_view text, std::string& out);
  Cycles cycles_to_run(CommandWords& words, std::string_view what);

  void read(CommandWords& words, std::string& out);
  void write(CommandWords& words, std::string& out);
  void run(CommandWords& words, std::string& out);
  void run_until_irq(CommandWords& words, std::string& out);
  void pin(CommandWords& words, std::string& out);
  void time(CommandWords& words, std::string& out);
  void batch(CommandWords& words, std::string& out);
  void vcd(CommandWords& words, std::string& out);
  void help(CommandWords& words, std::string& out);

  static const Command kCommands[];

  ServedSoc& soc_;
  WaveFolder waves_;
  const StopRequest* stop_ = nullptr;  // of the line under way
  std::int64_t lines_ = 0;
  std::int64_t cycles_left_ = 0;  // that the line under way may still run
  bool broken_ = false;
};

}  // namespace armature::cosim
