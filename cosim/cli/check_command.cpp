#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <iostream>
#include <iterator>
#include <mutex>
#include <optional>
#include <thread>

#include "cosim/cli/commands.hpp"
#include "cosim/cli/golden_run.hpp"
#include "cosim/cli/interrupt.hpp"
#include "cosim/report/junit.hpp"
#include "cosim/scenario/scenario_loader.hpp"
#include "cosim/text/text_file.hpp"
#include "cosim/trace/golden.hpp"

namespace armature::cosim {
namespace {

// Why a run did not pass, one reason a line; empty when it did.
std::string reasons(const RunSummary& summary) {
  std::string text;
  if (summary.failure) text += *summary.failure + '\n';
  for (const ExpectFailure& failure : summary.expect_failures) text += failure.text() + '\n';
  if (summary.golden.verdict == GoldenVerdict::kDiffers) text += summary.golden.report;
  return text;
}

// Nothing when the run was interrupted: then there is no verdict.
std::optional<JunitCase> check_scenario(const Scenario& scenario) {
  JunitCase result;
  result.name = scenario.name;
  try {
    const TemporaryFolder folder;
    const auto trace = folder.path() / "trace.csv";
    RunSummary summary = run_for_golden(scenario, trace, false);
    if (summary.interrupted) return std::nullopt;
    if (!summary.failure) summary.golden = check_golden(scenario, trace, summary.sha256);
    result.wall_s = summary.host.wall_s;
    result.output = summary_text(summary);
    result.failure = reasons(summary);
    if (summary.golden.verdict == GoldenVerdict::kNone && result.failure.empty()) {
      result.failure = "no golden.csv: run 'armature bless " + scenario.name + "'\n";
    }
  } catch (const std::exception& error) {
    result.error = error.what();
  }
  return result;
}

// Every one of the user's folders when none is named; of the program's when the user has none.
std::vector<std::filesystem::path> scenarios_to_check(const std::vector<std::string>& named, const SearchPath& path) {
  std::vector<std::filesystem::path> files;
  for (const std::string& name : named) std::ranges::move(find_scenario_files(name, path), std::back_inserter(files));
  for (const bool own : {true, false}) {
    if (files.empty()) files = path.scenarios(own);
  }
  if (files.empty()) throw InputError{"check", "no scenarios (searched: " + path.searched() + ")"};
  return files;
}

void print_verdict(const JunitCase& result) {
  const bool passed = result.failure.empty() && result.error.empty();
  std::cout << fmt::format("{}  {}  ({:.1f} s)\n", passed ? "PASS" : "FAIL", result.name, result.wall_s);
  for (const std::string& text : {result.failure, result.error}) {
    std::size_t begin = 0;
    while (begin < text.size()) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      std::cout << "      " << text.substr(begin, end - begin) << '\n';
      begin = end + 1;
    }
  }
  std::cout.flush();
}

}  // namespace

int check_command(const CheckArguments& arguments, const SearchPath& path) {
  std::vector<Scenario> scenarios;
  for (const auto& file : scenarios_to_check(arguments.scenarios, path))
    scenarios.push_back(load_scenario(file, {.search_path = path}));
  if (arguments.junit) require_writable(*arguments.junit);

  catch_interrupts();
  // Runs share nothing, so their results do not depend on how many run at a time.
  std::vector<std::optional<JunitCase>> results(scenarios.size());
  std::atomic<std::size_t> next{0};
  std::mutex printing;
  const auto work = [&] {
    for (std::size_t i = next++; i < scenarios.size() && !interrupted(); i = next++) {
      results[i] = check_scenario(scenarios[i]);
      if (!results[i]) return;
      const std::scoped_lock lock{printing};
      print_verdict(*results[i]);
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (int i = 1; i < arguments.jobs; ++i) helpers.emplace_back(work);
    work();
  }
  std::vector<JunitCase> finished;
  for (std::optional<JunitCase>& result : results) {
    if (result) finished.push_back(*std::move(result));
  }
  if (arguments.junit) replace_text_file(*arguments.junit, junit_xml(finished));
  const auto failed = std::ranges::count_if(
      finished, [](const JunitCase& result) { return !result.failure.empty() || !result.error.empty(); });
  std::cout << fmt::format("{} passed, {} failed", std::ssize(finished) - failed, failed);
  const auto skipped = results.size() - finished.size();
  std::cout << (skipped > 0 ? fmt::format(", {} not run: interrupted\n", skipped) : "\n");
  if (skipped > 0) return kExitInterrupted;
  return failed == 0 ? kExitOk : kExitCheckFailed;
}

}  // namespace armature::cosim
