// --shard I/N: a part of a work that several processes share.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cosim/text/text_file.hpp"

namespace armature::cosim {

struct Shard {
  std::int64_t index = 0, total = 1;
};

// Of the value of --shard; empty: of the environment variables TEST_SHARD_INDEX and TEST_TOTAL_SHARDS, as of
// GoogleTest, or all. Throws InputError.
[[nodiscard]] Shard shard_of(const std::string& option);

// The table of all shards, of the files of at least one. `parse` makes a table of the text and the name of a file.
// Throws InputError, as parse() and the tables do.
template <class Parse>
[[nodiscard]] auto merged_tables(const std::vector<std::filesystem::path>& files, Parse parse) {
  auto merged = parse(read_text_file(files.front(), kMaxTableBytes), files.front().string());
  for (std::size_t i = 1; i < files.size(); ++i) {
    merged.merge(parse(read_text_file(files[i], kMaxTableBytes), files[i].string()), files[i].string());
  }
  return merged;
}

}  // namespace armature::cosim
