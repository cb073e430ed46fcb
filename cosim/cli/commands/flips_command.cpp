#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/command/progress_count.hpp"
#include "cosim/cli/command/shard.hpp"
#include "cosim/cli/options/output_files.hpp"
#include "cosim/cli/options/output_options.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/cli/options/word_option.hpp"
#include "cosim/cli/run/interrupt.hpp"
#include "cosim/fabric/verilated_fabric.hpp"
#include "cosim/flips/drawn_flips.hpp"
#include "cosim/flips/flip_sweep.hpp"
#include "cosim/flips/flip_table.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/json.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/text_file.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {

// What flips: bits of flops, or of the memory of the cores.
enum class FlipsIn : std::uint8_t { kLogic, kMemory };

namespace {

constexpr const char* kInstructionTime = "cpu.cpi=1.5";

constexpr const char* kFlipsDetails = R"(Examples:
  armature flips
  armature flips fig9_joint_move --every 4000
  armature flips fig9_joint_move --every 500 --part u_axi_timer --jobs 2 --json
  armature flips fig9_joint_move --every 4000 --shard 0/2 --result first.json
  armature flips fig9_joint_move --every 4000 --shard 1/2 --result second.json
  armature flips --merge first.json second.json

Without a scenario it lists the flops of the logic and their bits, for the keys of [[fault]] with kind = "flop_flip".
With one it runs the scenario on the RTL once for each flip: of each bit, or of every K-th, at each instant. The instants
are spread over the time in which the arm moves, or over its begin (--until), each at a random clock edge of its tick. The
position of an axis may become wrong by a flip; that is detected at the next index pulse of its encoder, so let the arm
move on for a turn of its motors after the last instant. The outcomes are those of
'armature campaign': 'masked' is a flip after which all is soon as without it, 'finished' a run that ends at its target,
'stopped' one whose servo power was taken away. All others are silent errors. The last columns are the ticks of 50 us from
the flip to the first response. For each silent error it prints the command that repeats the run.
Registers that only hold a value for the next edge, and memories of the logic (arrays called 'memory'), are not flipped.
With --in memory it flips random bits of the memory of the cores, which execute their firmware: kind = "memory_flip".
Only the program 'armature-iss' can: armature-iss flips fig9_joint_move --in memory --bits 5 --part code
Each instruction takes 1.5 clocks there, so that an endless loop takes time.
A shard has every N-th flip from I on; TEST_TOTAL_SHARDS and TEST_SHARD_INDEX mean the same as --shard.
Exit code: 0 no silent error, 1 a silent error, or a shard is missing, 2 bad input, 3 internal error, 130 interrupted.)";

struct FlipsOptions {
  std::optional<std::string> scenario;
  std::optional<FlipsIn> in;  // none: the logic
  int instants = 1;
  double until_s = std::numeric_limits<double>::infinity();
  std::int64_t every = 1, bits = 100;
  std::uint64_t seed = 1;
  int jobs = 1;
  std::string part, shard;
  std::optional<std::filesystem::path> result;
  std::vector<std::filesystem::path> merge;
  OutputOptions output;
  [[nodiscard]] bool in_memory() const { return in == FlipsIn::kMemory; }
};

int list_flops(const FlipsOptions& given) {
  const std::vector<Flop> flops = make_verilated_fabric()->flops();
  std::int64_t bits = 0;
  Json list = Json::array();
  for (const Flop& flop : flops) {
    if (!given.part.empty() && block_of(flop.name) != given.part) continue;
    bits += flop.bits;
    list.push_back({{"flop", flop.name}, {"bits", flop.bits}});
    if (!given.output.json) std::cout << fmt::format("{:>4}  {}\n", flop.bits, flop.name);
  }
  if (given.output.json) {
    print_json({{"bits", bits}, {"flops", list}});
  } else if (!given.output.quiet) {
    std::cout << fmt::format("{:>4}  bits of {} flops\n", bits, list.size());
  }
  return list.empty() ? kExitBadInput : kExitOk;
}

void print_table(const FlipsOptions& given, const FlipTable& table) {
  if (given.result) replace_text_file(*given.result, to_json(table).dump(1) + '\n');
  if (given.output.json) {
    print_json(to_json(table));
    return;
  }
  if (!given.output.quiet) std::cout << flip_table_text(table);
  for (const FlipResult& result : table.silent) std::cout << printable_lines(silent_flip_text(result, table.head));
}

int merge_shards(const FlipsOptions& given) {
  const FlipTable merged = merged_tables(given.merge, flip_table);
  print_table(given, merged);
  if (merged.missing() != 0) std::cerr << fmt::format("{} flips are missing\n", merged.missing());
  return merged.silent.empty() && merged.missing() == 0 ? kExitOk : kExitCheckFailed;
}

// On the RTL, or with instructions that take time.
Scenario scenario_to_flip(const FlipsOptions& given, const SearchPath& path) {
  LoadOptions load{.search_path = path};
  load.logic.engine = Engine::kRtl;
  if (given.in_memory()) {
    load.processor = CpuKind::kA9;
    load.overrides = {kInstructionTime};
  }
  return load_scenario(*given.scenario, load);
}

std::vector<Flip> all_flips(const FlipsOptions& given, const Scenario& scenario) {
  if (given.in_memory()) return flips_of(memory_of(scenario), given.part, given.bits, given.seed);
  return flips_of(flops_of(scenario), given.part, given.every);
}

// Without results.
FlipTable new_table(const FlipsOptions& given, const std::vector<Cycles>& instants, Shard shard, std::size_t bits) {
  FlipTable table;
  table.head = {
      .scenario = *given.scenario,
      .seed = given.seed,
      .run = given.in_memory() ? fmt::format("armature-iss run --engine rtl --cpu a9 --set {}", kInstructionTime)
                               : "armature run --engine rtl",
      .bits = (given.in_memory() ? fmt::format("--bits {}", given.bits) : fmt::format("--every {}", given.every)) +
              (given.part.empty() ? "" : " --part " + given.part),
      .flips = static_cast<std::int64_t>(bits * instants.size())};
  for (const Cycles at : instants) table.head.instants_s.push_back(to_seconds(at));
  if (shard.total > 1) table.shards = {fmt::format("{}/{}", shard.index, shard.total)};
  return table;
}

int flip_all(const FlipsOptions& given, const SearchPath& path) {
  const Shard shard = shard_of(given.shard);
  const Scenario scenario = scenario_to_flip(given, path);
  const std::vector<Flip> all = all_flips(given, scenario);
  if (all.empty()) throw InputError{"--part", "nothing to flip, see 'armature flips --help'"};
  catch_interrupts();
  const std::optional<UnflippedRun> unflipped = run_unflipped(scenario, interrupted);
  if (!unflipped) return kExitInterrupted;
  if (unflipped->verdict.outcome != Outcome::kFinished) {
    throw InputError{scenario.file, fmt::format("expected a run that ends well without a flip, found {}: {}",
                                                outcome_text(unflipped->verdict.outcome), unflipped->verdict.reason)};
  }
  FlipSweep sweep{.flips = {},
                  .instants = instants_of(*unflipped, given.instants, given.until_s, given.seed),
                  .jobs = given.jobs,
                  .stop = interrupted};
  for (auto i = static_cast<std::size_t>(shard.index); i < all.size(); i += static_cast<std::size_t>(shard.total)) {
    sweep.flips.push_back(all[i]);
  }
  FlipTable table = new_table(given, sweep.instants, shard, all.size());
  {
    const ProgressCount progress{sweep.flips.size() * sweep.instants.size(), "flips", given.output.quiet};
    sweep.progress = progress.listener();
    for (const FlipResult& result : sweep_flips(scenario, *unflipped, sweep)) table.add(result);
  }
  print_table(given, table);
  if (interrupted()) return kExitInterrupted;
  return table.silent.empty() ? kExitOk : kExitCheckFailed;
}

int run_flips(const FlipsOptions& given, const SearchPath& path) {
  OutputFiles files;
  for (const std::filesystem::path& file : given.merge) files.reads(file);
  if (given.result) files.writes(*given.result, "--result", Writing::kInPlace);
  if (!given.merge.empty()) return merge_shards(given);
  return given.scenario ? flip_all(given, path) : list_flops(given);
}

CommandAction declare_flips(CLI::App& app) {
  const auto options = std::make_shared<FlipsOptions>();
  CLI::Option* scenario =
      app.add_option("scenario", options->scenario, "Scenario in which bits are flipped")->type_name(kScenarioValue);
  add_word_option(app, "--in", options->in, "Flip bits of the logic (default), or of the memory of the cores");
  app.add_option("--instants", options->instants, "Instants at which each bit is flipped, each in a run of its own")
      ->check(CLI::Range(1, 1'000))
      ->capture_default_str()
      ->needs(scenario);
  app.add_option("--until", options->until_s, "No flip after this time of the scenario [s]")
      ->check(CLI::PositiveNumber)
      ->needs(scenario);
  app.add_option("--every", options->every, "Flip every K-th bit only, in the order of the list")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000}))
      ->capture_default_str()
      ->needs(scenario);
  app.add_option("--bits", options->bits, "With --in memory: random bits of each part")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000}))
      ->capture_default_str()
      ->needs(scenario);
  app.add_option("--part", options->part, "Only this block of the logic, such as u_pulse_train, or part of the memory");
  app.add_option("--seed", options->seed, "Seed of the clock edges in their ticks, and of random bits")
      ->capture_default_str()
      ->needs(scenario);
  app.add_option("--jobs,-j", options->jobs, "Number of runs that are computed at the same time")
      ->check(CLI::Range(1, 256))
      ->capture_default_str()
      ->needs(scenario);
  app.add_option("--shard", options->shard, "Only part I of N parts of the flips, I from 0: I/N")->needs(scenario);
  app.add_option("--result", options->result, "Write the table as JSON to this file, for --merge")
      ->type_name(kFileValue)
      ->needs(scenario);
  app.add_option("--merge", options->merge, "Run nothing: add the tables of these shards")
      ->type_name(kFileValue)
      ->excludes(scenario);
  add_quiet_option(app, options->output);
  add_json_option(app, options->output);
  return [options](const CommonOptions& common) { return run_flips(*options, common.search_path()); };
}

}  // namespace

Subcommand flips_command() {
  return {.name = "flips",
          .order = 26,
          .summary = "List the flops of the logic, or flip bits and look for silent errors",
          .details = kFlipsDetails,
          .declare = declare_flips};
}

}  // namespace armature::cosim
