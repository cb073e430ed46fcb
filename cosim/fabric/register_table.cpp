#include "cosim/fabric/register_table.hpp"

#include <fmt/format.h>

#include "cosim/fabric/register_names.hpp"

namespace armature::cosim {

std::string register_name(Variant variant, std::uint32_t address) {
  constexpr std::uint32_t kStride = 4;
  for (const RegisterName& row : kRegisterNames) {
    if (!(variant == Variant::kPaper ? row.in_paper : row.in_counts) || address < row.address) continue;
    const std::uint32_t element = (address - row.address) / kStride;
    if (element >= row.count) continue;
    return row.count == 1 ? row.name : fmt::format("{}[{}]", row.name, element);
  }
  return {};
}

}  // namespace armature::cosim
