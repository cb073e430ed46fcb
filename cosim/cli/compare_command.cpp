#include "cosim/trace/compare.hpp"

#include <fmt/format.h>

#include <iostream>

#include "cosim/cli/commands.hpp"
#include "cosim/cli/run_folder.hpp"

namespace armature::cosim {

int compare_command(const CompareArguments& arguments) {
  for (const std::filesystem::path& file : {arguments.a, arguments.b}) {
    const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path{"."};
    if (const auto why = why_unfinished(folder)) std::cerr << fmt::format("{}: unfinished: {}\n", file.string(), *why);
  }
  const Comparison comparison = compare_traces(arguments.a, arguments.b);
  std::cout << comparison.report();
  return comparison.equal() ? kExitOk : kExitCheckFailed;
}

}  // namespace armature::cosim
