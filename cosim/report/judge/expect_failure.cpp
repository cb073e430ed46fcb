#include "cosim/report/judge/expect_failure.hpp"

namespace armature::cosim {

std::string ExpectFailure::place() const {
  if (file.empty() && origin.override_text.empty()) return {};
  return place_text(file, origin);
}

std::string ExpectFailure::text() const {
  const std::string here = place();
  std::string all = here.empty() ? "" : here + ": ";
  all.append("expect.").append(key).append(": expected ").append(expected).append(", got ").append(got);
  if (!where.text.empty()) all.append(" (").append(where.text).append(")");
  return all;
}

}  // namespace armature::cosim
