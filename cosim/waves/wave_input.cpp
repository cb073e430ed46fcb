#include "cosim/waves/wave_input.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "cosim/text/input_error.hpp"
#include "cosim/text/shell_text.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFstEnd = ".fst";

bool is_blank(char c) {
  return static_cast<unsigned char>(c) <= ' ';
}

}  // namespace

bool is_wave_name(const fs::path& file) {
  return file.extension() == ".vcd" || file.extension() == kFstEnd;
}

WaveInput::WaveInput(const fs::path& file) : name_{file.string()}, pipe_{file.extension() == kFstEnd} {
  require_regular_file(file);
  stream_ = std::fopen(name_.c_str(), "rb");
  if (stream_ == nullptr) throw InputError{name_, std::string{"cannot open: "} + std::strerror(errno)};
  if (!pipe_) return;
  std::fclose(stream_);
  stream_ = nullptr;
  if (std::system("command -v fst2vcd >/dev/null 2>&1") != 0) {
    throw InputError{name_, "needs the program fst2vcd (Debian package gtkwave), which is not installed"};
  }
  stream_ = popen(("exec fst2vcd -f " + shell_word(name_) + " 2>/dev/null").c_str(), "r");
  if (stream_ == nullptr) throw InputError{name_, std::string{"cannot start fst2vcd: "} + std::strerror(errno)};
}

WaveInput::~WaveInput() {
  if (stream_ != nullptr) close();
}

int WaveInput::close() {
  std::FILE* const stream = std::exchange(stream_, nullptr);
  return pipe_ ? pclose(stream) : std::fclose(stream);
}

std::string_view WaveInput::word() {
  for (;;) {
    while (begin_ < end_ && is_blank(buffer_[begin_])) ++begin_;
    std::size_t stop = begin_;
    while (stop < end_ && !is_blank(buffer_[stop])) ++stop;
    if (stop < end_) {
      const std::string_view found{&buffer_[begin_], stop - begin_};
      begin_ = stop;
      return found;
    }
    if (!fill()) return {};
  }
}

bool WaveInput::fill() {
  if (stream_ == nullptr) return false;
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  if (end_ == buffer_.size()) throw InputError{name_, "expected words of less than 128 KiB"};
  const std::size_t bytes = std::fread(buffer_.data() + end_, 1, buffer_.size() - end_, stream_);
  end_ += bytes;
  if (bytes > 0) return true;
  if (std::ferror(stream_) != 0) throw InputError{name_, "cannot read"};
  ends_early_ = begin_ < end_;
  if (close() != 0) throw InputError{name_, pipe_ ? "fst2vcd cannot read it" : "cannot read"};
  return false;
}

}  // namespace armature::cosim
