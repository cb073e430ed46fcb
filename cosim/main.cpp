#include "cosim/cli/main/cli.hpp"

int main(int argc, char** argv) {
  return armature::cosim::cli_main(argc, argv);
}
