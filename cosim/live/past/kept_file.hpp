// A file of results that is cut when its run goes back.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace armature::cosim {

class KeptFile {
 public:
  // An empty path: nothing is written. The functions throw InputError when the file cannot be written.
  explicit KeptFile(std::filesystem::path file);

  // The file has so many bytes, and then this text: what it had behind them is gone.
  void write(std::int64_t bytes, std::string_view text);
  // The file gets what it has so far, so that it remains when this process is killed.
  void write_through();

 private:
  void require_written() const;

  std::filesystem::path file_;
  std::ofstream stream_;
  std::int64_t size_ = 0;
};

}  // namespace armature::cosim
