#include "cosim/fabric/wave_file.hpp"

#include <csignal>
#include <string>

namespace armature::cosim {
namespace {

std::string shell_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string{"'\\''"} : std::string{c};
  return quoted + "'";
}

}  // namespace

bool WaveFile::open(const std::string& name) {
  close();
  name_ = name;
  error_.clear();
  pipe_ = format_ == WaveFormat::kFst;
  if (pipe_) {
    // If the converter ends early, close() must report it; SIGPIPE must not end this program.
    std::signal(SIGPIPE, SIG_IGN);
    // The converter ignores Ctrl-C: it must run until the simulation has closed the pipe.
    file_ = popen(("trap '' INT; exec vcd2fst -v - -f " + shell_quoted(name) + " >/dev/null").c_str(), "w");
    // Without this date the converter would write the time of day into the file.
    if (file_ != nullptr) std::fputs("$date none $end\n", file_);
  } else {
    file_ = std::fopen(name.c_str(), "w");
  }
  return file_ != nullptr;
}

void WaveFile::close() {
  if (file_ == nullptr) return;
  if (pipe_) {
    if (pclose(file_) != 0) error_ = name_ + ": vcd2fst (Debian package gtkwave) failed";
  } else {
    if (std::fclose(file_) != 0) error_ = name_ + ": cannot write the waveform file";
  }
  file_ = nullptr;
}

ssize_t WaveFile::write(const char* data, ssize_t bytes) {
  return static_cast<ssize_t>(std::fwrite(data, 1, static_cast<std::size_t>(bytes), file_));
}

}  // namespace armature::cosim
