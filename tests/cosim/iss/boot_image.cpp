// boot_image SCENARIO FILE: writes the memory that the controller starts with, as the host of the scenario fills it.
#include <fstream>

#include "controller/host_memory/boot_memory.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/scenario/to_controller.hpp"

int main(int argc, char** argv) {
  using namespace armature;
  if (argc != 3) return 2;
  host_memory::BootMemory boot = cosim::to_boot_memory(cosim::load_scenario(argv[1], {}));
  std::ofstream file{argv[2], std::ios::binary};
  const void* const bytes = &boot.memory();
  file.write(static_cast<const char*>(bytes), boot.memory().bytes);
  return file.flush() ? 0 : 1;
}
