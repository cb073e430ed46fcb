#include "cosim/scenario/files/belt_policy_file.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <utility>

#include "cosim/text/csv_line.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/printable.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxPolicyBytes = 64u << 10U;
constexpr double kMostOfAnInput = 1e9;
constexpr double kMostCorrection_mm = 100;

// The words of one line.
class PolicyLine {
 public:
  PolicyLine(std::string_view text, const std::string& file, int line) : text_{text}, file_{file}, line_{line} {}

  // Empty at the end of the line.
  [[nodiscard]] std::string_view next() {
    const std::size_t begin = std::min(text_.find_first_not_of(" \t\r"), text_.size());
    const std::size_t end = std::min(text_.find_first_of(" \t\r", begin), text_.size());
    const std::string_view word = text_.substr(begin, end - begin);
    text_.remove_prefix(end);
    return word;
  }
  [[nodiscard]] double number(double least, double most) {
    const std::string_view word = next();
    const std::optional<double> value = parsed_number<double>(word);
    if (!value || !(*value >= least && *value <= most)) {
      refuse("expected a number, found \"" + printable(std::string{word}) + "\"");
    }
    return *value;
  }
  [[nodiscard]] std::uint32_t hexadecimal(std::string_view word) const {
    constexpr std::size_t kDigits = 8;
    const auto value = parsed_number<std::uint32_t>(word, 16);
    if (word.size() != kDigits || !value) {
      refuse("expected 8 hexadecimal digits, found \"" + printable(std::string{word}) + "\"");
    }
    return *value;
  }
  void end() {
    if (const std::string_view word = next(); !word.empty()) {
      refuse("unexpected \"" + printable(std::string{word}) + "\"");
    }
  }
  [[noreturn]] void refuse(const std::string& why) const {
    Problem problem;
    problem.file = file_;
    problem.origin.line = line_;
    problem.message = why;
    throw InputError{problem};
  }

 private:
  std::string_view text_;
  const std::string& file_;
  int line_;
};

class PolicyReader {
 public:
  explicit PolicyReader(const std::string& file) : file_{file} {}

  void read(std::string_view text, int number) {
    PolicyLine line{text.substr(0, text.find('#')), file_, number};
    const std::string_view word = line.next();
    if (word.empty()) return;
    if (word == "image") return read_image(line);
    if (word == "full_mm") {
      config_.full_mm = line.number(1e-6, kMostCorrection_mm);
    } else if (word == "input") {
      read_input(line);
    } else if (word == "crc") {
      config_.crc = line.hexadecimal(line.next());
      has_crc_ = true;
    } else {
      line.refuse("expected full_mm, input, crc or image, found \"" + printable(std::string{word}) + "\"");
    }
    line.end();
  }

  [[nodiscard]] BeltPolicyConfig config() const {
    const auto need = [&](bool there, const std::string& what) {
      if (!there) throw InputError{file_, "has no " + what};
    };
    need(config_.full_mm > 0, "full_mm");
    need(inputs_ == BeltPolicyConfig::kInputs, std::to_string(BeltPolicyConfig::kInputs) + " lines \"input\"");
    need(has_crc_, "crc");
    need(config_.words > 0, "image");
    return config_;
  }

 private:
  void read_input(PolicyLine& line) {
    if (inputs_ == BeltPolicyConfig::kInputs) line.refuse("too many inputs");
    BeltPolicyConfig::Range& range = config_.inputs.at(inputs_++);
    range.low = line.number(-kMostOfAnInput, kMostOfAnInput);
    range.high = line.number(-kMostOfAnInput, kMostOfAnInput);
    if (!(range.low < range.high)) line.refuse("expected a range that ascends");
  }
  void read_image(PolicyLine& line) {
    for (std::string_view word = line.next(); !word.empty(); word = line.next()) {
      if (config_.words == BeltPolicyConfig::kMaxWords) line.refuse("the image is too long");
      config_.image.at(config_.words++) = line.hexadecimal(word);
    }
  }

  const std::string& file_;
  BeltPolicyConfig config_;
  std::size_t inputs_ = 0;
  bool has_crc_ = false;
};

}  // namespace

BeltPolicyConfig parse_belt_policy(std::string_view text, const std::string& name) {
  PolicyReader reader{name};
  for (int line = 1; !text.empty(); ++line) reader.read(pop_line(text), line);
  return reader.config();
}

void load_belt_policy(Scenario& scenario, std::vector<Problem>& all) {
  if (!scenario.conveyor || !scenario.conveyor->policy) return;
  BeltPolicySpec& policy = *scenario.conveyor->policy;
  const fs::path file = fs::path{scenario.file}.parent_path() / policy.file_name;
  const std::string name = file.lexically_normal().string();
  try {
    const std::string text = read_ascii_file(file, kMaxPolicyBytes);
    policy.network = parse_belt_policy(text, name);
    scenario.sources.push_back(input_file(name, text));
  } catch (const InputError& error) {
    all.insert(all.end(), error.problems().begin(), error.problems().end());
  }
}

}  // namespace armature::cosim
