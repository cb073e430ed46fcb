#include "cosim/iss/debug/run_messages.hpp"

#include <algorithm>

namespace armature::cosim::iss {

DebugAnswer text_answer(std::string_view text) {
  DebugAnswer answer;
  answer.size = static_cast<std::uint32_t>(std::min(text.size(), kMessageBytes));
  std::copy_n(text.begin(), answer.size, answer.bytes.begin());
  return answer;
}

}  // namespace armature::cosim::iss
