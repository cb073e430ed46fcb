#include "cosim/exports/mcap_writer.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "cosim/exports/crc32.hpp"
#include "cosim/exports/little_endian.hpp"
#include "cosim/text/version.hpp"

namespace armature::cosim {
namespace {

constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};
constexpr std::size_t kChunkBytes = std::size_t{1} << 20U;

enum class Op : std::uint8_t {
  kHeader = 1,
  kFooter = 2,
  kSchema = 3,
  kChannel = 4,
  kMessage = 5,
  kChunk = 6,
  kMessageIndex = 7,
  kChunkIndex = 8,
  kStatistics = 11,
  kDataEnd = 15,
};

// A kind, the length in eight bytes, the content.
void append_record(std::string& bytes, Op op, std::string_view content) {
  append_number(bytes, static_cast<std::uint8_t>(op));
  append_number(bytes, std::uint64_t{content.size()});
  bytes.append(content);
}

std::string mcap_header() {
  std::string content, record;
  append_text(content, "");  // no profile
  append_text(content, "armature " + std::string{version()});
  append_record(record, Op::kHeader, content);
  return record;
}

void append_schema(std::string& records, std::uint16_t id, const McapChannel& channel) {
  std::string content;
  append_number(content, id);
  append_text(content, channel.schema_name);
  append_text(content, "jsonschema");
  append_text(content, channel.schema);
  append_record(records, Op::kSchema, content);
}

void append_channel(std::string& records, std::uint16_t id, std::uint16_t schema, const McapChannel& channel) {
  std::string content;
  append_number(content, id);
  append_number(content, schema);
  append_text(content, channel.topic);
  append_text(content, "json");
  append_number(content, std::uint32_t{0});  // no metadata
  append_record(records, Op::kChannel, content);
}

}  // namespace

McapWriter::McapWriter(std::ostream& out, std::vector<McapChannel> channels)
    : out_{out}, channels_{std::move(channels)}, counts_(channels_.size()) {
  std::map<std::string, std::uint16_t> ids;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    const auto [known, is_new] = ids.emplace(channels_[i].schema_name, static_cast<std::uint16_t>(schemas_ + 1));
    if (is_new) append_schema(declarations_, ++schemas_, channels_[i]);
    append_channel(declarations_, static_cast<std::uint16_t>(i), known->second, channels_[i]);
  }
  put(kMagic);
  put(mcap_header());
  put(declarations_);
}

void McapWriter::put(std::string_view bytes) {
  out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  written_ += bytes.size();
}

void McapWriter::write(std::size_t channel, std::uint64_t time_ns, std::string_view json) {
  if (std::ranges::all_of(counts_, [](std::uint64_t count) { return count == 0; })) first_ns_ = time_ns;
  last_ns_ = std::max(last_ns_, time_ns);
  const auto id = static_cast<std::uint16_t>(channel);
  if (chunk_.records.empty()) chunk_.first_ns = chunk_.last_ns = time_ns;
  chunk_.first_ns = std::min(chunk_.first_ns, time_ns);
  chunk_.last_ns = std::max(chunk_.last_ns, time_ns);
  chunk_.index[id].push_back({time_ns, chunk_.records.size()});
  constexpr std::uint64_t kFields = 2 + 4 + 8 + 8;
  append_number(chunk_.records, static_cast<std::uint8_t>(Op::kMessage));
  append_number(chunk_.records, kFields + json.size());
  append_number(chunk_.records, id);
  append_number(chunk_.records, static_cast<std::uint32_t>(counts_[channel]++));
  append_number(chunk_.records, time_ns);
  append_number(chunk_.records, time_ns);  // when it was published
  chunk_.records.append(json);
  if (chunk_.records.size() >= kChunkBytes) end_chunk();
}

void McapWriter::end_chunk() {
  if (chunk_.records.empty()) return;
  const std::uint64_t start = written_;
  std::string times, content;
  append_number(times, chunk_.first_ns);
  append_number(times, chunk_.last_ns);
  content = times;
  append_number(content, std::uint64_t{chunk_.records.size()});
  append_number(content, crc32(chunk_.records));
  append_text(content, "");  // no compression
  append_number(content, std::uint64_t{chunk_.records.size()});
  content += chunk_.records;
  std::string record;
  append_record(record, Op::kChunk, content);
  put(record);
  const std::uint64_t chunk_length = written_ - start;
  std::string offsets;  // of the indexes of messages, for each channel
  for (const auto& [channel, entries] : chunk_.index) {
    append_number(offsets, channel);
    append_number(offsets, written_);
    std::string index;
    append_number(index, channel);
    append_number(index, static_cast<std::uint32_t>(entries.size() * sizeof(IndexEntry)));
    for (const IndexEntry& entry : entries) {
      append_number(index, entry.time_ns);
      append_number(index, entry.offset);
    }
    record.clear();
    append_record(record, Op::kMessageIndex, index);
    put(record);
  }
  content = times;
  append_number(content, start);
  append_number(content, chunk_length);
  append_text(content, offsets);
  append_number(content, written_ - start - chunk_length);
  append_text(content, "");
  append_number(content, std::uint64_t{chunk_.records.size()});
  append_number(content, std::uint64_t{chunk_.records.size()});
  append_record(chunk_indexes_, Op::kChunkIndex, content);
  ++chunks_;
  chunk_.records.clear();
  chunk_.index.clear();
}

void McapWriter::append_summary(std::string& summary) const {
  summary += declarations_;
  std::string content;
  append_number(content, std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0}));
  append_number(content, schemas_);
  append_number(content, static_cast<std::uint32_t>(channels_.size()));
  append_number(content, std::uint32_t{0});  // attachments
  append_number(content, std::uint32_t{0});  // metadata
  append_number(content, chunks_);
  append_number(content, first_ns_);
  append_number(content, last_ns_);
  std::string counts;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    append_number(counts, static_cast<std::uint16_t>(i));
    append_number(counts, counts_[i]);
  }
  append_text(content, counts);
  append_record(summary, Op::kStatistics, content);
  summary += chunk_indexes_;
}

void McapWriter::finish() {
  end_chunk();
  std::string end;
  append_record(end, Op::kDataEnd, std::string(4, '\0'));  // without a check sum of all chunks
  put(end);
  std::string summary;
  const std::uint64_t summary_start = written_;
  append_summary(summary);
  // The check sum is that of the summary and of the footer before it.
  append_number(summary, static_cast<std::uint8_t>(Op::kFooter));
  append_number(summary, std::uint64_t{8 + 8 + 4});
  append_number(summary, summary_start);
  append_number(summary, std::uint64_t{0});  // no offsets of groups
  append_number(summary, crc32(summary));
  put(summary);
  put(kMagic);
}

}  // namespace armature::cosim
