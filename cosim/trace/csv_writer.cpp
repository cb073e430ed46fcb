#include "cosim/trace/csv_writer.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>

#include "cosim/text/input_error.hpp"

namespace armature::cosim {
namespace {

constexpr std::size_t kCsvBufferSize = std::size_t{256} * 1024;

[[noreturn]] void fail(const std::filesystem::path& file) {
  throw InputError{file.string(), std::string{"cannot write: "} + std::strerror(errno)};
}

}  // namespace

CsvWriter::CsvWriter(const std::filesystem::path& file, std::int64_t every_ticks, ToolColumns tool_columns)
    : path_{file}, lines_{every_ticks, tool_columns}, buffer_(kCsvBufferSize) {
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  file_.reset(std::fopen(file.c_str(), "wb"));
  if (file_ == nullptr) fail(path_);
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);  // buffered here
  const std::string header = lines_.header();
  used_ = static_cast<std::size_t>(std::copy(header.begin(), header.end(), buffer_.begin()) - buffer_.begin());
}

CsvWriter::~CsvWriter() {
  if (file_ != nullptr) std::fwrite(buffer_.data(), 1, used_, file_.get());
}

void CsvWriter::append(const TraceRow& row, const IntegerDigest& digest) {
  if (kCsvBufferSize - used_ < TraceLines::kMaxText) flush();
  const char* const end = lines_.append(buffer_.data() + used_, row, digest);
  used_ = static_cast<std::size_t>(end - buffer_.data());
  ++rows_;
}

void CsvWriter::flush() {
  if (std::fwrite(buffer_.data(), 1, used_, file_.get()) != used_) fail(path_);
  used_ = 0;
}

void CsvWriter::close() {
  if (file_ == nullptr) return;
  flush();
  if (std::fclose(file_.release()) != 0) fail(path_);
}

}  // namespace armature::cosim
