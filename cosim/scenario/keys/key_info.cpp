#include "cosim/scenario/keys/key_info.hpp"

namespace armature::cosim {

std::string condition_text(const Condition& condition) {
  std::string text{condition.key};
  if (!condition.values.empty()) text += " = " + quoted_list(condition.values);
  return text;
}

}  // namespace armature::cosim
