// The reference vectors of tests/reference.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace armature::test {

inline nlohmann::json read_reference(const std::string& file) {
  std::ifstream in{std::string{ARMATURE_SOURCE_DIR} + "/tests/reference/" + file};
  if (!in) throw std::runtime_error{"cannot open tests/reference/" + file};
  return nlohmann::json::parse(in);
}

}  // namespace armature::test
