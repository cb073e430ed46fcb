#include "cosim/live/past/kept_file.hpp"

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "cosim/text/input_error.hpp"

namespace armature::cosim {

KeptFile::KeptFile(std::filesystem::path file) : file_{std::move(file)} {
  if (file_.empty()) return;
  errno = 0;
  stream_.open(file_, std::ios::binary | std::ios::trunc);
  require_written();
}

void KeptFile::write(std::int64_t bytes, std::string_view text) {
  if (file_.empty()) return;
  if (bytes != size_) {
    write_through();
    std::error_code error;
    std::filesystem::resize_file(file_, static_cast<std::uintmax_t>(bytes), error);
    if (error) throw InputError{file_.string(), "cannot cut it: " + error.message()};
    stream_.seekp(bytes);
  }
  stream_.write(text.data(), static_cast<std::streamsize>(text.size()));
  size_ = bytes + static_cast<std::int64_t>(text.size());
}

void KeptFile::write_through() {
  if (file_.empty()) return;
  errno = 0;
  stream_.flush();
  require_written();
}

void KeptFile::require_written() const {
  if (!stream_) throw InputError{file_.string(), std::string{"cannot write: "} + std::strerror(errno)};
}

}  // namespace armature::cosim
