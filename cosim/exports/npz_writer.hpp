// Writes NPZ, the archive of arrays of NumPy: a ZIP file with a file NAME.npy for each array, without compression.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace armature::cosim {

class NpzWriter {
 public:
  // `out` must outlive the writer and be at its beginning; its errors are the caller's to find.
  explicit NpzWriter(std::ostream& out) : out_{out} {}
  // Arrays of one dimension. The names differ.
  void write(std::string_view name, const std::vector<std::int64_t>& values);
  void write(std::string_view name, const std::vector<double>& values);
  void write(std::string_view name, const std::vector<std::string>& values);  // of ASCII characters
  // Ends the file. Throws InputError if it has more than 4 GiB, of which a plain ZIP file cannot tell.
  void finish();

 private:
  void add_file(const std::string& name, std::string_view bytes);

  std::ostream& out_;
  std::uint64_t written_ = 0;
  std::string directory_;
  std::uint16_t files_ = 0;
};

}  // namespace armature::cosim
