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

#include "controller/base/timebase.hpp"
#include "cosim/campaign/draw.hpp"
#include "cosim/cli/command/command.hpp"
#include "cosim/cli/command/shard.hpp"
#include "cosim/cli/options/output_files.hpp"
#include "cosim/cli/options/output_options.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/cli/run/interrupt.hpp"
#include "cosim/fabric/verilated_fabric.hpp"
#include "cosim/flops/flop_table.hpp"
#include "cosim/report/format/progress_bar.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/json.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/text_file.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kFlopsDetails = R"(Examples:
  armature flops
  armature flops fig9_joint_move --every 4000
  armature flops fig9_joint_move --every 500 --block u_axi_timer --jobs 2 --json
  armature flops fig9_joint_move --every 4000 --shard 0/2 --result first.json
  armature flops fig9_joint_move --every 4000 --shard 1/2 --result second.json
  armature flops --merge first.json second.json

Without a scenario it lists the flops of the logic and their bits, for the keys of [[fault]] with kind = "flop_flip".
With one it runs the scenario on the RTL once for each flip: of each bit, or of every K-th, at each instant. The instants
are spread over the time in which the arm moves, or over its begin (--until), each at a random clock edge of its tick. The
position of an axis may become wrong by a flip; that is detected at the next index pulse of its encoder, so let the arm
move on for a turn of its motors after the last instant. The outcomes are those of
'armature campaign': 'masked' is a flip after which logic, pins and responses are soon as without it, 'finished' a run that
ends at its target, 'stopped' one whose servo power was taken away. All others are silent errors. The last columns are the ticks
of 50 us from the flip to the first response. For each silent error it prints the command that repeats the run.
Registers that only hold a value for the next edge, and memories (arrays called 'memory'), are not flipped.
A shard has every N-th flip from I on; TEST_TOTAL_SHARDS and TEST_SHARD_INDEX mean the same as --shard.
Exit code: 0 no silent error, 1 a silent error, or a shard is missing, 2 bad input, 3 internal error, 130 interrupted.)";

struct FlopsOptions {
  std::optional<std::string> scenario;
  int instants = 1;
  double until_s = std::numeric_limits<double>::infinity();
  std::int64_t every = 1;
  std::uint64_t seed = 1;
  int jobs = 1;
  std::string block, shard;
  std::optional<std::filesystem::path> result;
  std::vector<std::filesystem::path> merge;
  OutputOptions output;
};

int list_flops(const FlopsOptions& given) {
  const std::vector<Flop> flops = make_verilated_fabric()->flops();
  std::int64_t bits = 0;
  Json list = Json::array();
  for (const Flop& flop : flops) {
    if (!given.block.empty() && block_of(flop.name) != given.block) continue;
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

// Spread over the ticks in which the motors move.
std::vector<Cycles> instants_of(const UnflippedRun& run, const FlopsOptions& given) {
  const std::vector<TruePoint>& points = run.path.points;
  const auto moves = [&](std::size_t i) { return points[i].motor_counts != points[i + 1].motor_counts; };
  std::size_t first = 0, last = points.size() - 1;
  while (first + 1 < last && !moves(first)) ++first;
  while (last > first + 1 && (!moves(last - 1) || to_seconds(Cycles{points[last].cycle}) > given.until_s)) --last;
  Draw draw{given.seed, 0, 0};
  std::vector<Cycles> instants;
  const auto count = static_cast<std::size_t>(given.instants);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t tick = first + (last - first) * (2 * i + 1) / (2 * count);
    instants.emplace_back(points[tick].cycle + draw.integer(1, armature::kTickCycles.value()));
  }
  return instants;
}

std::vector<FlopBit> bits_of(const std::vector<Flop>& flops, const FlopsOptions& given, Shard shard) {
  std::vector<FlopBit> chosen;
  std::int64_t bits = 0, number = 0;
  for (const Flop& flop : flops) {
    if (!given.block.empty() && block_of(flop.name) != given.block) continue;
    for (int bit = 0; bit < flop.bits; ++bit) {
      if (bits++ % given.every != 0) continue;
      if (number++ % shard.total == shard.index) chosen.push_back({flop.name, bit});
    }
  }
  return chosen;
}

void print_table(const FlopsOptions& given, const FlopTable& table) {
  if (given.result) replace_text_file(*given.result, to_json(table).dump(1) + '\n');
  if (given.output.json) {
    print_json(to_json(table));
    return;
  }
  if (!given.output.quiet) std::cout << flop_table_text(table);
  for (const FlopResult& result : table.silent) {
    std::cout << printable_lines(silent_flip_text(result, table.head.scenario));
  }
}

int merge_tables(const FlopsOptions& given) {
  std::optional<FlopTable> merged;
  for (const std::filesystem::path& file : given.merge) {
    const FlopTable table = flop_table(read_text_file(file, kMaxTableBytes), file.string());
    if (merged) {
      merged->merge(table, file.string());
    } else {
      merged = table;
    }
  }
  print_table(given, *merged);
  if (merged->missing() != 0) std::cerr << fmt::format("{} flips are missing\n", merged->missing());
  return merged->silent.empty() && merged->missing() == 0 ? kExitOk : kExitCheckFailed;
}

// Without results.
FlopTable new_table(const FlopsOptions& given, const FlopSweep& sweep, Shard shard, std::int64_t bits) {
  FlopTable table;
  table.head = {
      .scenario = *given.scenario,
      .seed = given.seed,
      .flops = fmt::format("--every {}{}{}", given.every, given.block.empty() ? "" : " --block ", given.block),
      .flips = bits * static_cast<std::int64_t>(sweep.instants.size())};
  for (const Cycles at : sweep.instants) table.head.instants_s.push_back(to_seconds(at));
  if (shard.total > 1) table.shards = {fmt::format("{}/{}", shard.index, shard.total)};
  return table;
}

int run_flops(const FlopsOptions& given, const SearchPath& path) {
  OutputFiles files;
  for (const std::filesystem::path& file : given.merge) files.reads(file);
  if (given.result) files.writes(*given.result, "--result", Writing::kInPlace);
  if (!given.merge.empty()) return merge_tables(given);
  if (!given.scenario) return list_flops(given);
  const Shard shard = shard_of(given.shard);
  LoadOptions load{.search_path = path};
  load.logic.engine = Engine::kRtl;
  const Scenario scenario = load_scenario(*given.scenario, load);
  catch_interrupts();
  const std::optional<UnflippedRun> unflipped = run_unflipped(scenario, interrupted);
  if (!unflipped) return kExitInterrupted;
  if (unflipped->verdict.outcome != Outcome::kFinished) {
    throw InputError{scenario.file, fmt::format("expected a run that ends well without a flip, found {}: {}",
                                                outcome_text(unflipped->verdict.outcome), unflipped->verdict.reason)};
  }
  const std::vector<Flop> flops = flops_of(scenario);
  FlopSweep sweep{.bits = bits_of(flops, given, shard),
                  .instants = instants_of(*unflipped, given),
                  .jobs = given.jobs,
                  .stop = interrupted};
  if (sweep.bits.empty()) throw InputError{"--block", "no flop, see 'armature flops'"};
  const bool shows_progress = !given.output.quiet && stderr_is_terminal();
  if (shows_progress) {
    sweep.progress = [&](std::size_t done) {
      std::cerr << fmt::format("\r{} of {} flips", done, sweep.bits.size() * sweep.instants.size()) << std::flush;
    };
  }
  const std::vector<FlopResult> results = sweep_flops(scenario, *unflipped, sweep);
  if (shows_progress) std::cerr << "\r\x1b[K" << std::flush;
  const auto bits = static_cast<std::int64_t>(bits_of(flops, given, Shard{}).size());
  FlopTable table = new_table(given, sweep, shard, bits);
  for (const FlopResult& result : results) table.add(result);
  print_table(given, table);
  if (interrupted()) return kExitInterrupted;
  return table.silent.empty() ? kExitOk : kExitCheckFailed;
}

CommandAction declare_flops(CLI::App& app) {
  const auto options = std::make_shared<FlopsOptions>();
  CLI::Option* scenario = app.add_option("scenario", options->scenario, "Scenario in which each flop is flipped")
                              ->type_name(kScenarioValue);
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
  app.add_option("--block", options->block, "Only the flops of this block, such as u_pulse_train");
  app.add_option("--seed", options->seed, "Seed of the clock edges in their ticks")
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
  return [options](const CommonOptions& common) { return run_flops(*options, common.search_path()); };
}

}  // namespace

Subcommand flops_command() {
  return {.name = "flops",
          .order = 26,
          .summary = "List the flops of the logic, or flip each of them and look for silent errors",
          .details = kFlopsDetails,
          .declare = declare_flops};
}

}  // namespace armature::cosim
