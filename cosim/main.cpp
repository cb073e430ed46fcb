#include "cosim/cli/commands/cli.hpp"

int main(int argc, char** argv) {
  return armature::cosim::cli_main(argc, argv);
}
