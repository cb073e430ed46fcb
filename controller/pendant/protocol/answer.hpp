// What the controller replies to a command.
#pragma once

#include <cstdint>

#include "controller/pendant/protocol/frame_table.hpp"

namespace armature::pendant {

struct Answer {
  Status status = Status::kOk;
  std::int32_t payload = 0;
};

}  // namespace armature::pendant
