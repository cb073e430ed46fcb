// Writes MCAP (https://mcap.dev/spec): messages with times on channels, in chunks with an index, without compression.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace armature::cosim {

// Messages of a channel are JSON that a JSON Schema describes.
struct McapChannel {
  std::string topic;        // such as /tool_pose
  std::string schema_name;  // such as foxglove.PoseInFrame; channels of one name have one schema
  std::string schema;       // the JSON Schema
};

class McapWriter {
 public:
  // Begins the file. `out` must outlive the writer and be at its beginning; its errors are the caller's to find.
  McapWriter(std::ostream& out, std::vector<McapChannel> channels);
  // `channel`: its place in the list. `time_ns` should not go back.
  void write(std::size_t channel, std::uint64_t time_ns, std::string_view json);
  // Ends the file. Nothing may be written after it.
  void finish();

 private:
  struct IndexEntry {
    std::uint64_t time_ns, offset;  // in the chunk
  };
  struct Chunk {
    std::string records;
    std::uint64_t first_ns = 0, last_ns = 0;
    std::map<std::uint16_t, std::vector<IndexEntry>> index;
  };

  void put(std::string_view bytes);
  void end_chunk();
  void append_summary(std::string& summary) const;

  std::ostream& out_;
  std::uint64_t written_ = 0;
  std::vector<McapChannel> channels_;
  std::string declarations_;  // records of schemas and channels
  std::uint16_t schemas_ = 0;
  Chunk chunk_;
  std::string chunk_indexes_;  // records
  std::uint32_t chunks_ = 0;
  std::vector<std::uint64_t> counts_;  // messages of each channel
  std::uint64_t first_ns_ = 0, last_ns_ = 0;
};

}  // namespace armature::cosim
