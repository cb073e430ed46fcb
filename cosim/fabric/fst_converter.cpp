#include "cosim/fabric/fst_converter.hpp"

#include <cstdlib>

namespace armature::cosim {

bool fst_converter_available() {
  return std::system("command -v vcd2fst >/dev/null 2>&1") == 0;
}

}  // namespace armature::cosim
