#include "cosim/trace/integer_digest.hpp"

#include "cosim/trace/columns.hpp"

namespace armature::cosim {
namespace {

// Rows are hashed in blocks, because the set-up of a call costs more than hashing one row.
constexpr std::size_t kDigestBufferSize = std::size_t{64} * 1024;

}  // namespace

IntegerDigest::IntegerDigest() : buffer_(kDigestBufferSize) {
  sha256_.add(integer_header() + "\n");
}

void IntegerDigest::add(const TraceRow& row) {
  if (kDigestBufferSize - used_ < kMaxPartText + 1) flush();
  char* end = append_integers(buffer_.data() + used_, row);
  *end++ = '\n';
  used_ = static_cast<std::size_t>(end - buffer_.data());
  prefix_.clear();
}

std::string IntegerDigest::hex() const {
  flush();
  return sha256_.hex();
}

// Finishing a copy of the hash takes a microsecond, so this is called only for rows that are written.
std::string_view IntegerDigest::prefix() const {
  if (prefix_.empty()) prefix_ = hex().substr(0, kPrefixDigits);
  return prefix_;
}

void IntegerDigest::flush() const {
  sha256_.add({buffer_.data(), used_});
  used_ = 0;
}

}  // namespace armature::cosim
