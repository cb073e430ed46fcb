#include "cosim/trace/compare.hpp"

#include <fmt/format.h>

#include <iostream>
#include <system_error>

#include "cosim/cli/commands.hpp"
#include "cosim/cli/run_folder.hpp"
#include "cosim/scenario/search_path.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {

int compare_command(const CompareArguments& arguments) {
  for (const std::filesystem::path& file : {arguments.a, arguments.b}) {
    const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path{"."};
    if (const auto why = why_unfinished(folder))
      std::cerr << fmt::format("{}: unfinished: {}\n", printable(file.string(), kShowAll), *why);
  }
  Comparison comparison = compare_traces(arguments.a, arguments.b);
  // Of a golden it is known where it comes from.
  const std::filesystem::path folder = arguments.a.parent_path();
  if (std::error_code ignored; std::filesystem::exists(folder / kScenarioFile, ignored)) {
    comparison.scenario = folder.empty() ? "." : folder.string();
  }
  std::cout << printable_lines(comparison.report());
  return comparison.equal() ? kExitOk : kExitCheckFailed;
}

}  // namespace armature::cosim
