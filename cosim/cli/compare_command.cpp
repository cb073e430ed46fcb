#include "cosim/trace/compare.hpp"

#include <iostream>

#include "cosim/cli/commands.hpp"

namespace armature::cosim {

int compare_command(const CompareArguments& arguments) {
  const Comparison comparison = compare_traces(arguments.a, arguments.b);
  std::cout << comparison.report();
  return comparison.equal() ? kExitOk : kExitCheckFailed;
}

}  // namespace armature::cosim
