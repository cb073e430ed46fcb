// What the simulation costs per clock, against the verilated model alone, in one process.
//
//   bare      the model with idle inputs, clock toggled in a loop: the limit
//   run       fig9_joint_move, nothing recorded
//   recorded  the same with facts, full-rate hash and the 1 kHz trace file, as `armature run` does
//
// The three alternate, and each figure is the smallest processor time of all rounds, so that other load on the machine
// hardly matters. usage: cycle_loop_bench [ROUNDS]
#include <Varm_soc.h>
#include <fmt/format.h>
#include <verilated.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <limits>

#include "cosim/fabric/verilated_fabric.hpp"
#include "cosim/kernel/clock.hpp"
#include "cosim/kernel/simulation.hpp"
#include "cosim/report/run_facts.hpp"
#include "cosim/scenario/scenario_loader.hpp"
#include "cosim/trace/csv_writer.hpp"
#include "cosim/trace/integer_digest.hpp"

namespace {

using namespace armature;
using namespace armature::cosim;

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Figure {
  double seconds = std::numeric_limits<double>::infinity();
  void measure(const std::function<void()>& work) {
    const double start = processor_seconds();
    work();
    seconds = std::min(seconds, processor_seconds() - start);
  }
};

void toggle_bare_model(std::int64_t cycles) {
  VerilatedContext context;
  Varm_soc model{&context};
  model.estop_ni = 1;
  model.rst_ni = 0;
  const auto edge = [&model] {
    model.clk_i = 1;
    model.eval();
    model.clk_i = 0;
    model.eval();
  };
  for (int i = 0; i < 16; ++i) edge();
  model.rst_ni = 1;
  for (std::int64_t i = 0; i < cycles; ++i) edge();
}

class Silent : public SimulationListener {
 public:
  void on_row(const TraceRow&) override {}
  void on_move_started(const MoveReport&) override {}
  void on_command(const MoveSpec&, Cycles) override {}
  void on_move_refused(const MoveRefusal&, Cycles) override {}
  void on_fault(const Telemetry&, Cycles) override {}
  bool stop_requested() override { return false; }
};

class Recording final : public Silent {
 public:
  explicit Recording(const Scenario& scenario) : facts_{scenario.robot, 1} {}
  void on_row(const TraceRow& row) override {
    digest_.add(row);
    trace_.write(row);
    facts_.add(row);
  }

 private:
  RunFactsCollector facts_;
  IntegerDigest digest_;
  CsvWriter trace_{std::filesystem::temp_directory_path() / "armature_bench.csv", 20};
};

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 3;
  const std::filesystem::path scenarios = ARMATURE_SOURCE_DIR "/scenarios";
  const Scenario scenario = load_scenario(scenarios / "fig9_joint_move", {.scenarios_dir = scenarios, .overrides = {}});
  const Cycles cycles = to_cycles(scenario.duration_s);

  Figure bare, run, recorded;
  for (int round = 0; round < rounds; ++round) {
    bare.measure([&] { toggle_bare_model(cycles.value()); });
    run.measure([&] {
      Silent silent;
      Simulation{scenario, make_verilated_fabric(), silent}.run();
    });
    recorded.measure([&] {
      Recording recording{scenario};
      Simulation{scenario, make_verilated_fabric(), recording}.run();
    });
  }
  std::filesystem::remove(std::filesystem::temp_directory_path() / "armature_bench.csv");

  const auto line = [&](const char* name, const Figure& figure) {
    const double count = static_cast<double>(cycles.value());
    fmt::print("{:<10} {:6.1f} ns/cycle  {:6.2f} Mcycles/s  real-time factor {:.3f}\n", name,
               1e9 * figure.seconds / count, 1e-6 * count / figure.seconds, to_seconds(cycles) / figure.seconds);
  };
  fmt::print("fig9_joint_move, {} cycles, best of {} rounds\n", cycles.value(), rounds);
  line("bare", bare);
  line("run", run);
  line("recorded", recorded);
  fmt::print("run / bare       {:.3f}   (at most 1.5)\n", run.seconds / bare.seconds);
  fmt::print("recorder's cost  {:.2f} %  (under 3 %)\n", 100.0 * (recorded.seconds / run.seconds - 1.0));
  return 0;
}
