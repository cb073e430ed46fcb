#include "cosim/schema/file_kinds.hpp"

#include "cosim/schema/json_schema.hpp"

namespace armature::cosim {

std::string schema_text(const FileKind& kind) {
  return json_schema(kind.keys(), "urn:armature:" + std::string{kind.name}, std::string{kind.title});
}

}  // namespace armature::cosim
