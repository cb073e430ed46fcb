#include "cosim/page/serial_record.hpp"

#include <cstdlib>
#include <string_view>

#include "cosim/text/input_error.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

constexpr double kTogetherS = 0.005;  // characters that are closer are one text
enum Field : std::size_t { kTimeField, kDirectionField, kByteField, kCharField, kErrorField, kFields = 7 };

std::vector<std::string> split_line(std::string_view line) {
  std::vector<std::string> fields;
  while (true) {
    const std::size_t comma = line.find(',');
    fields.emplace_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

}  // namespace

std::vector<SerialRecord> read_serial_record(const std::filesystem::path& file) {
  if (!is_file(file)) return {};
  const std::string text = read_text_file(file, kMostTableBytes);
  std::vector<SerialRecord> records;
  double last_s = 0;
  std::string_view rest = text;
  for (int line = 1; !rest.empty(); ++line) {
    const std::size_t end = rest.find('\n');
    const std::vector<std::string> fields = split_line(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    if (line == 1) continue;
    if (fields.size() != kFields) {
      throw InputError{
          Problem{file.string(), Origin{line, 0, {}}, {}, "expected 7 values, as 'armature run' writes them"}};
    }
    const double time_s = std::strtod(fields[kTimeField].c_str(), nullptr);
    const bool more = !records.empty() && records.back().direction == fields[kDirectionField] &&
                      records.back().error == fields[kErrorField] && time_s - last_s < kTogetherS;
    if (!more) records.push_back({time_s, fields[kDirectionField], {}, fields[kErrorField]});
    records.back().text += fields[kCharField];
    last_s = time_s;
  }
  return records;
}

}  // namespace armature::cosim
