#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "controller/base/words.hpp"
#include "cosim/campaign/campaign.hpp"
#include "cosim/campaign/campaign_part.hpp"
#include "cosim/campaign/campaign_report.hpp"
#include "cosim/campaign/campaign_table.hpp"
#include "cosim/campaign/draw_fault.hpp"
#include "cosim/campaign/shrink.hpp"
#include "cosim/cli/command/command.hpp"
#include "cosim/cli/command/progress_count.hpp"
#include "cosim/cli/command/shard.hpp"
#include "cosim/cli/options/output_files.hpp"
#include "cosim/cli/options/output_options.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/cli/options/word_option.hpp"
#include "cosim/cli/run/interrupt.hpp"
#include "cosim/cli/run/temporary_folder.hpp"
#include "cosim/report/format/junit.hpp"
#include "cosim/scenario/files/robot_loader.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/shell_text.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kCampaignDetails = R"(Examples:
  armature campaign --runs 12
  armature campaign --runs 12 --jobs 2 --junit campaign.xml --html campaign.html
  armature campaign --only 7
  armature campaign --runs 12 --kind pulse_loss --kind encoder_noise --robot kuka_kr6_r900
  armature campaign --runs 12 --shard 0/2 --result first.json
  armature campaign --runs 12 --shard 1/2 --result second.json
  armature campaign --merge first.json second.json

Each run has a random robot and random moves, or a program, and none, one or two random faults of the kinds of [[fault]].
The first of six runs has no fault: the others, with the same moves, are compared with it. Each run ends in one outcome.
'finished': at its end, and no count is lost. 'stopped': the servo power was taken away, and the right axis was blamed.
'masked': nothing differed. All others are silent errors: 'wrong position', 'motion after stop', 'limit exceeded',
'hang', 'servos on' after a stop was demanded, 'too late' (off the path before anything was detected), 'wrong fault',
and 'failed' (an invariant does not hold). The judge looks at motors, pins and servo power, and at the robot file.

The last columns of the table are the ticks of 50 us from the begin of the fault to the first response. For each silent
error it prints the command that repeats the run. The first of them are shrunk: --out gets a scenario with the fewest
moves and faults that still fail, which 'armature run' takes. Results depend on --seed, --engine, --robot and --kind
alone. A shard computes the groups of six runs whose number modulo N is I. The environment variables TEST_TOTAL_SHARDS and
TEST_SHARD_INDEX, as of GoogleTest, mean the same as --shard.
Exit code: 0 no silent error, 1 a silent error, or a shard is missing, 2 bad input, 3 internal error, 130 interrupted.)";

struct CampaignOptions {
  std::int64_t runs = 200;
  std::uint64_t seed = 1;
  int jobs = 1;
  std::string shard;                // I/N; empty: of the environment
  std::optional<Engine> engine;     // none: the model
  std::vector<std::string> robots;  // empty: those of the program
  std::vector<std::string> kinds;   // of faults; empty: all
  std::optional<std::int64_t> only;
  std::filesystem::path out = "out/campaign";
  int shrunk = 3;  // silent errors that are shrunk
  std::optional<std::filesystem::path> junit, html, result;
  std::vector<std::filesystem::path> merge;
  OutputOptions output;
};

Engine engine_of(const CampaignOptions& given) {
  return given.engine.value_or(Engine::kModel);
}

// Those that came with the program, or else the last folder of the path has.
std::vector<std::string> default_robots(const SearchPath& path) {
  if (path.folders().empty()) return {};
  std::vector<std::string> names = list_robots(path.folders().back().robots());
  std::erase(names, "vo2021_6r_overloaded");  // carries more than its drives can hold, so no run of it ends well
  return names;
}

CampaignSpec campaign_spec(const CampaignOptions& given, const SearchPath& path) {
  CampaignSpec spec{.seed = given.seed, .robots = {}, .kinds = given.kinds, .load = {.search_path = path}};
  spec.load.logic.engine = engine_of(given);
  std::vector<std::string> names = given.robots;
  if (names.empty()) names = default_robots(path);
  for (const std::string& name : names) {
    RobotSpec robot = find_robot(name, path);
    if (name.ends_with(".toml")) robot.name = std::filesystem::absolute(name).string();  // as scenarios name it
    spec.robots.push_back(std::move(robot));
  }
  if (spec.robots.empty()) throw InputError{"campaign", "no robots (searched: " + path.searched() + ")"};
  return spec;
}

// The command line that gives these results, without what says which runs and where the results go.
std::string replay_command(const CampaignOptions& given) {
  std::string command = fmt::format("armature campaign --seed {}", given.seed);
  if (engine_of(given) != Engine::kModel) command += fmt::format(" --engine {}", word_of(*given.engine));
  for (const std::string& robot : given.robots) command += " --robot " + shell_word(robot);
  for (const std::string& kind : given.kinds) command += " --kind " + kind;
  return command;
}

// The results of a shard, or of one run alone. A group that was interrupted has none.
std::vector<CampaignResult> run_all(const CampaignOptions& given, const CampaignSpec& spec, Shard shard) {
  CampaignPart part{.jobs = given.jobs, .stop = interrupted};
  const std::int64_t end = (given.runs + kGroupRuns - 1) / kGroupRuns;
  for (std::int64_t group = shard.index; group < end; group += shard.total) part.groups.push_back(group);
  if (given.only) part.groups = {*given.only / kGroupRuns};
  part.wanted = [&](std::int64_t run) { return given.only ? run == *given.only : run < given.runs; };
  const ProgressCount progress{part.groups.size(), "groups of runs", given.output.quiet};
  part.progress = progress.listener();
  const TemporaryFolder folder;
  return run_part(spec, part, folder.path());
}

void write_results(const CampaignOptions& given, const CampaignTable& table, const std::string& replay) {
  if (given.result) replace_text_file(*given.result, to_json(table).dump(1) + '\n');
  if (given.junit) replace_text_file(*given.junit, junit_xml(campaign_cases(table, replay)));
  if (given.html) replace_text_file(*given.html, campaign_page(table, replay));
}

void print_table(const CampaignOptions& given, const CampaignTable& table, const std::string& replay) {
  if (given.output.json) {
    print_json(to_json(table));
    return;
  }
  if (!given.output.quiet) std::cout << campaign_text(table);
  for (const SilentRun& run : table.silent) std::cout << printable_lines(silent_run_text(run, replay));
}

// Of the first silent errors: a scenario with what they need.
void write_shrunk(const CampaignOptions& given, const CampaignSpec& spec, const std::vector<CampaignResult>& results) {
  int left = given.shrunk;
  const TemporaryFolder folder;
  for (const CampaignResult& result : results) {
    if (!is_silent(result.verdict.outcome) || left-- <= 0 || interrupted()) continue;
    const CampaignResult least = shrink(spec, result, folder.path());
    const std::filesystem::path kept = given.out / fmt::format("run_{}", result.run);
    write_case(least.drawn, kept);
    if (given.output.json) continue;
    std::cout << printable_lines(fmt::format(
        "run {} shrunk to {} of {} steps, {} of {} faults: armature run {}\n", result.run, least.drawn.steps.size(),
        result.drawn.steps.size(), least.drawn.faults.size(), result.drawn.faults.size(), shell_word(kept.string())));
  }
}

// One run, with its scenario.
void print_only(const CampaignOptions& given, const CampaignResult& result) {
  const std::filesystem::path kept = given.out / fmt::format("run_{}_whole", result.run);
  write_case(result.drawn, kept);
  if (given.output.json) return;
  std::cout << printable_lines(fmt::format("run {}: {}{}{}\n", result.run, outcome_text(result.verdict.outcome),
                                           result.verdict.reason.empty() ? "" : ": ", result.verdict.reason));
  for (const std::string& fault : result.faults) std::cout << "      " << printable(fault) << '\n';
  std::cout << printable_lines(fmt::format("to see it: armature run {}\n", shell_word(kept.string())));
}

int merge_shards(const CampaignOptions& given, const SearchPath& path) {
  const CampaignTable merged = merged_tables(given.merge, campaign_table);
  CampaignOptions of_table = given;
  of_table.seed = merged.head.seed;
  of_table.engine = enumerator_of<Engine>(merged.head.engine);
  of_table.kinds = merged.head.only_kinds;
  if (merged.head.robots != default_robots(path)) of_table.robots = merged.head.robots;
  const std::string replay = replay_command(of_table);
  write_results(given, merged, replay);
  print_table(given, merged, replay);
  if (!merged.is_complete()) std::cerr << fmt::format("{} runs are missing\n", merged.head.runs - merged.done);
  return merged.silent.empty() && merged.is_complete() ? kExitOk : kExitCheckFailed;
}

void claim_outputs(const CampaignOptions& given) {
  OutputFiles files;
  for (const std::filesystem::path& file : given.merge) files.reads(file);
  if (given.junit) files.writes(*given.junit, "--junit", Writing::kInPlace);
  if (given.html) files.writes(*given.html, "--html", Writing::kInPlace);
  if (given.result) files.writes(*given.result, "--result", Writing::kInPlace);
}

int run_campaign(const CampaignOptions& given, const SearchPath& path) {
  claim_outputs(given);
  if (!given.merge.empty()) return merge_shards(given, path);
  const Shard shard = shard_of(given.shard);
  const CampaignSpec spec = campaign_spec(given, path);
  catch_interrupts();
  const std::vector<CampaignResult> results = run_all(given, spec, shard);
  CampaignTable table{
      .head = {.seed = given.seed, .runs = given.runs, .engine = std::string{word_of(engine_of(given))}}};
  table.head.only_kinds = given.kinds;
  for (const RobotSpec& robot : spec.robots) table.head.robots.push_back(robot.name);
  if (shard.total > 1) table.shards = {fmt::format("{}/{}", shard.index, shard.total)};
  for (const CampaignResult& result : results) table.add(result);
  const std::string replay = replay_command(given);
  if (given.only && !results.empty()) print_only(given, results.front());
  write_results(given, table, replay);
  if (!given.only || given.output.json) print_table(given, table, replay);
  write_shrunk(given, spec, results);
  if (interrupted()) return kExitInterrupted;
  return table.silent.empty() ? kExitOk : kExitCheckFailed;
}

CommandAction declare_campaign(CLI::App& app) {
  const auto options = std::make_shared<CampaignOptions>();
  constexpr std::int64_t kMostRuns = 1'000'000'000;
  CLI::Option* runs = app.add_option("--runs", options->runs, "Number of runs")
                          ->check(CLI::Range(std::int64_t{1}, kMostRuns))
                          ->capture_default_str();
  app.add_option("--seed", options->seed, "Seed of everything that is drawn")->capture_default_str();
  app.add_option("--jobs,-j", options->jobs, "Number of groups of runs that are computed at the same time")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  CLI::Option* shard = app.add_option("--shard", options->shard, "Only part I of N parts of the runs, I from 0: I/N");
  add_word_option(app, "--engine", options->engine, "What computes the logic, as of 'armature run'");
  app.add_option("--robot", options->robots,
                 "Robot to draw from (default: those of the program that can carry their payload). May be repeated")
      ->type_name(kRobotValue);
  // The description of the check is a list of all kinds, too long for a line of the help.
  app.add_option("--kind", options->kinds, "Kind of fault to draw, as of [[fault]] (default: all). May be repeated")
      ->type_name("KIND")
      ->check(CLI::IsMember(std::vector<std::string>(fault_kind_names().begin(), fault_kind_names().end()))
                  .description(""));
  app.add_option("--only", options->only, "Only the run of this number, from 0; its scenario is written to --out")
      ->check(CLI::Range(std::int64_t{0}, kMostRuns))
      ->excludes(shard)
      ->excludes(runs);
  app.add_option("--out", options->out, "Folder for scenarios of silent errors")
      ->type_name(kFolderValue)
      ->capture_default_str();
  app.add_option("--shrink", options->shrunk, "Number of silent errors that are shrunk")
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  app.add_option("--result", options->result, "Write the table as JSON to this file, for --merge")
      ->type_name(kFileValue);
  app.add_option("--junit", options->junit, "Write a verdict for each kind of fault as JUnit XML to this file")
      ->type_name(kFileValue);
  app.add_option("--html", options->html, "Write the table and the silent errors as a page to this file")
      ->type_name(kFileValue);
  app.add_option("--merge", options->merge, "Run nothing: add the tables of these shards")->type_name(kFileValue);
  add_quiet_option(app, options->output);
  add_json_option(app, options->output);
  return [options](const CommonOptions& common) { return run_campaign(*options, common.search_path()); };
}

}  // namespace

Subcommand campaign_command() {
  return {.name = "campaign",
          .order = 25,
          .summary = "Run random moves with random faults and look for silent errors",
          .details = kCampaignDetails,
          .declare = declare_campaign};
}

}  // namespace armature::cosim
