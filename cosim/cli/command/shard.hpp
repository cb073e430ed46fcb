// --shard I/N: a part of a work that several processes share.
#pragma once

#include <cstdint>
#include <string>

namespace armature::cosim {

struct Shard {
  std::int64_t index = 0, total = 1;
};

// Of the value of --shard; empty: of the environment variables TEST_SHARD_INDEX and TEST_TOTAL_SHARDS, as of
// GoogleTest, or all. Throws InputError.
[[nodiscard]] Shard shard_of(const std::string& option);

}  // namespace armature::cosim
