#include "cosim/page/serial_record.hpp"

#include <cstdlib>
#include <string_view>

#include "cosim/text/csv_line.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

constexpr double kTogetherS = 0.005;  // characters that are closer are one text
enum Field : std::size_t { kTimeField, kDirectionField, kByteField, kCharField, kErrorField, kFields = 7 };

}  // namespace

std::vector<SerialRecord> read_serial_record(const std::filesystem::path& file) {
  if (!is_file(file)) return {};
  const std::string text = read_text_file(file, kMaxTableBytes);
  std::vector<SerialRecord> records;
  double last_s = 0;
  CsvLine fields{file.string()};
  std::string_view rest = text;
  for (int line = 1; !rest.empty(); ++line) {
    fields.set(line, pop_line(rest));
    if (line == 1) continue;
    if (fields.values().size() != kFields) {
      throw InputError{
          Problem{file.string(), Origin{line, 0, {}}, {}, "expected 7 values, as 'armature run' writes them"}};
    }
    const double time_s = std::strtod(std::string{fields[kTimeField]}.c_str(), nullptr);
    const bool more = !records.empty() && records.back().direction == fields[kDirectionField] &&
                      records.back().error == fields[kErrorField] && time_s - last_s < kTogetherS;
    if (!more) records.push_back({time_s, std::string{fields[kDirectionField]}, {}, std::string{fields[kErrorField]}});
    records.back().text += fields[kCharField];
    last_s = time_s;
  }
  return records;
}

}  // namespace armature::cosim
