// The trace of a run in memory, a block for each quantity: as Python's arrays need it, without text and without copies.
//
// A block has room for every row of the run from the beginning, so it never moves. The operating system gives it memory
// as the rows come. A row that is written does not change. A block lives as long as somebody has its pointer, also
// after the run.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "cosim/run/run_listener.hpp"
#include "cosim/scenario/scenario.hpp"
#include "cosim/trace/columns.hpp"

namespace armature::cosim {

class TraceColumns final : public RunListener {
 public:
  enum class Type : std::uint8_t { kInteger, kReal };  // std::int64_t, double

  struct Block {
    std::string_view name;
    Type type;
    std::size_t width;           // values of a row, which follow each other: 1, an axis each, or x, y, z
    std::shared_ptr<void> data;  // rows() rows are written
  };

  // The rows whose tick is a multiple of `every_ticks`, which is at least 1. Throws std::bad_alloc when the rows of the
  // whole run have no room in the address space.
  TraceColumns(const Scenario& scenario, std::int64_t every_ticks);

  // tick; time_s; state: number of MotionState; cmd_pulses, pin_pulses, enc_counts, corr_pulses, ref_deg, enc_deg: six
  // axes each; tcp_ref_mm and tcp_enc_mm, if trace.csv of the scenario has them. scenarios/RESULTS.md describes them.
  [[nodiscard]] std::span<const Block> blocks() const { return blocks_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }

  // RunListener
  void on_row(const TraceRow& row, const IntegerDigest& digest) override;

 private:
  template <class Value>
  Value* add(std::string_view name, std::size_t width);

  const std::int64_t every_ticks_;
  const std::size_t room_;
  std::vector<Block> blocks_;
  std::int64_t* tick_;
  double* time_s_;
  std::int64_t *state_, *commanded_, *pins_, *encoder_, *correction_;
  double *reference_deg_, *actual_deg_;
  double* tool_reference_mm_ = nullptr;
  double* tool_actual_mm_ = nullptr;
  std::atomic<std::size_t> rows_ = 0;  // another thread may read while the run goes on
};

}  // namespace armature::cosim
