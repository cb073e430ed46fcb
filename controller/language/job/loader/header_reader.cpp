#include "controller/language/job/loader/header_reader.hpp"

#include <algorithm>
#include <optional>

#include "controller/language/job/loader/line_lexer.hpp"
#include "controller/language/job/loader/position_line.hpp"
#include "controller/language/job/memory/number_text.hpp"

namespace armature::job {
namespace {

struct FrameName {
  std::string_view name;
  Frame frame;
};
constexpr std::array<FrameName, 7> kFrameNames{{{"PULSE", Frame::kPulse},
                                                {"ANGLE", Frame::kAngle},
                                                {"ROBOT", Frame::kRobot},
                                                {"BASE", Frame::kBase},
                                                {"USER", Frame::kUser},
                                                {"TOOL", Frame::kTool},
                                                {"MTOOL", Frame::kMasterTool}}};

// Kept as they are and without effect here.
constexpr std::array<std::string_view, 12> kOnlyKept{"FOLDERNAME", "DATE",   "COMM",   "ATTR",    "FRAME",   "GROUP1",
                                                     "GROUP2",     "GROUP3", "GROUP4", "ARGTYPE", "COMMENT", "LIMIT"};

bool any_of(const auto& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Without blanks at its end.
std::string_view without_end(std::string_view text) {
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace

void HeaderReader::begin(JobInfo& job) noexcept {
  job_ = &job;
  section_ = Section::kNothing;
  has_name_ = false;
  modal_ = Position{};
  npos_line_ = 0;
  npos_ = {};
  counted_ = {};
}

void HeaderReader::keep(std::string_view line) noexcept {
  if (memory_.header_count == memory_.headers.size()) {
    return file_.error(1, "the program memory has no room for more header lines");
  }
  const auto text = add_text(memory_, line);
  if (!text) return file_.error(1, "the program memory has no room for more text");
  memory_.headers[memory_.header_count++] = {.text = *text};
}

bool HeaderReader::read(std::string_view line) noexcept {
  const std::size_t slashes = place_where(line, [](char character) { return character != '/'; });
  if (slashes == 0) {
    if (in_instructions()) return false;
    if (part(line, 0, 1) == "'") {
      keep(line);
    } else if (section_ == Section::kPos && !line.empty()) {
      read_position(line);
    } else {
      if (section_ == Section::kNothing) {
        file_.error(1, "expected /JOB");
        section_ = Section::kJob;
      } else if (!line.empty() && section_ != Section::kArguments) {
        file_.error(1, "expected a line that begins with a slash");
      }
      keep(line);
    }
    return true;
  }
  keep(line);
  const std::string_view rest = part(line, slashes);
  const std::size_t size = place_where(rest, is_blank);
  const std::size_t value = place_where(
      rest, [](char character) { return !is_blank(character); }, size);
  read_pseudo(part(rest, 0, size), part(rest, value), slashes + value + 1);
  return true;
}

void HeaderReader::enter(Section section, std::string_view name) noexcept {
  if (section <= section_) file_.error(1, DiagnosticText{name} << " is not expected here");
  section_ = std::max(section_, section);
}

void HeaderReader::read_pseudo(std::string_view name, std::string_view value, std::size_t column) noexcept {
  if (name == "JOB") return enter(Section::kJob, "/JOB");
  if (section_ == Section::kNothing) {
    file_.error(1, "expected /JOB");
    section_ = Section::kJob;
  }
  if (name == "NAME") return read_name(value, column);
  if (name == "POS") return enter(Section::kPos, "//POS");
  if (name == "ARGINFO") return enter(Section::kArguments, "//ARGINFO");
  if (name == "INST") return enter(Section::kInst, "//INST");
  std::array<std::int64_t, 32> numbers{};
  if (name == "NPOS") {
    const int count = read_numbers(value, column, npos_.size(), numbers);
    if (count < 0) return;
    npos_line_ = file_.line;
    std::copy_n(numbers.begin(), npos_.size(), npos_.begin());
  } else if (name == "USER") {
    modal_.user = static_cast<std::uint8_t>(read_one(value, column, 63));
  } else if (name == "TOOL") {
    modal_.tool = static_cast<std::uint8_t>(read_one(value, column, 63));
  } else if (name == "POSTYPE") {
    read_postype(value, column);
  } else if (name == "PULSE") {
    modal_.frame = Frame::kPulse;
  } else if (name == "ANGLE") {
    modal_.frame = Frame::kAngle;
  } else if (name == "RECTAN") {
    // Old files have no POSTYPE.
    if (holds_joints(modal_.frame)) modal_.frame = Frame::kBase;
  } else if (name == "RCONF") {
    read_rconf(value, column);
  } else if (name == "LVARS") {
    const int count = read_numbers(value, column, job_->locals.size(), numbers);
    for (int i = 0; i < count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      job_->locals[at] = static_cast<std::uint16_t>(std::clamp<std::int64_t>(numbers[at], 0, 256));
      if (numbers[at] > 256) file_.error(column, "more than 256 local variables of one type");
    }
  } else if (!any_of(kOnlyKept, name)) {
    file_.warn(1, DiagnosticText{"unknown line '"} << name << "' is kept and has no effect");
  }
}

void HeaderReader::read_name(std::string_view value, std::size_t column) noexcept {
  const std::string_view name = without_end(value);
  if (has_name_) return file_.error(1, "a second //NAME");
  has_name_ = true;
  if (name.empty() || name.size() > 32) return file_.error(column, "expected a name of 1 to 32 characters");
  if (memory_.job_named(name) < memory_.job_count) {
    return file_.error(column, DiagnosticText{"a job named "} << name << " is loaded already");
  }
  const TextRef line = memory_.headers[memory_.header_count - 1].text;
  job_->name = {static_cast<std::uint16_t>(line.start + column - 1), static_cast<std::uint16_t>(name.size())};
}

void HeaderReader::read_postype(std::string_view value, std::size_t column) noexcept {
  const std::string_view name = without_end(value);
  for (const FrameName& known : kFrameNames) {
    if (known.name == name) {
      modal_.frame = known.frame;
      return;
    }
  }
  file_.error(column, "expected PULSE, ANGLE, ROBOT, BASE, USER, TOOL or MTOOL");
}

void HeaderReader::read_rconf(std::string_view value, std::size_t column) noexcept {
  std::array<std::int64_t, 32> numbers{};
  const int count = read_numbers(value, column, 24, numbers);
  if (count < 0) return;
  modal_.rconf = Position::kHasRconf;
  bool others = false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    if (i < 6 && numbers[i] > 1) return file_.error(column, "the first six fields of RCONF are 0 or 1");
    if (i < 6 && numbers[i] == 1) modal_.rconf = static_cast<std::uint8_t>(modal_.rconf | 1U << i);
    others = others || (i >= 6 && numbers[i] != 0);
  }
  if (others) file_.warn(column, "fields 7 to 24 of RCONF have no effect");
}

int HeaderReader::read_numbers(std::string_view value, std::size_t column, std::size_t most,
                               std::array<std::int64_t, 32>& numbers) noexcept {
  const auto fail = [&](std::size_t at, std::string_view text) {
    file_.error(column + at, text);
    return -1;
  };
  std::size_t at = 0;
  int count = 0;
  while (true) {
    while (at < value.size() && value[at] == ' ') ++at;
    const std::size_t start = at;
    std::int64_t number = 0;
    for (; at < value.size() && is_digit(value[at]) && at < start + 9; ++at) number = 10 * number + (value[at] - '0');
    if (at == start) return fail(at, "expected a whole number");
    if (static_cast<std::size_t>(count) == most) return fail(start, "too many numbers");
    numbers[static_cast<std::size_t>(count++)] = number;
    while (at < value.size() && value[at] == ' ') ++at;
    if (at == value.size()) return count;
    if (value[at] != ',') return fail(at, "expected a comma");
    ++at;
  }
}

std::int64_t HeaderReader::read_one(std::string_view value, std::size_t column, std::int64_t most) noexcept {
  std::array<std::int64_t, 32> numbers{};
  if (read_numbers(value, column, 1, numbers) < 0) return 0;
  if (numbers[0] > most) return file_.error(column, DiagnosticText{"expected a number from 0 to "} << most), 0;
  return numbers[0];
}

void HeaderReader::read_position(std::string_view line) noexcept {
  PositionLine reader{line, modal_};
  if (!reader.read()) return file_.error(reader.problem().column, reader.problem().text);
  Position position = reader.position();
  position.line = static_cast<std::uint16_t>(file_.line);
  const auto before =
      std::span{memory_.positions}.subspan(job_->first_position, memory_.position_count - job_->first_position);
  for (const Position& other : before) {
    if (other.letter == position.letter && other.number == position.number) {
      return file_.error(1, DiagnosticText{"the same position as in line "} << std::uint32_t{other.line});
    }
  }
  ++counted_[static_cast<std::size_t>(position.letter)];
  if (memory_.position_count == memory_.positions.size()) {
    return file_.error(1, DiagnosticText{"the program memory has room for "} << kMaxPositions << " positions");
  }
  if (memory_.header_count == memory_.headers.size()) {
    return file_.error(1, "the program memory has no room for more header lines");
  }
  memory_.headers[memory_.header_count++] = {.is_position = true,
                                             .position = static_cast<std::uint16_t>(memory_.position_count)};
  memory_.positions[memory_.position_count++] = position;
}

void HeaderReader::finish() noexcept {
  if (section_ == Section::kNothing) return file_.error(1, "expected /JOB");
  if (!has_name_) file_.error(1, "the job has no //NAME");
  if (!in_instructions()) file_.error(1, "the job has no //INST");
  const bool any = std::any_of(counted_.begin(), counted_.end(), [](std::int64_t count) { return count > 0; });
  if (npos_line_ == 0) {
    if (any) file_.error(1, "the job has positions, and no ///NPOS");
    return;
  }
  for (std::size_t i = 0; i < npos_.size(); ++i) {
    if (npos_[i] == counted_[i]) continue;
    file_.line = npos_line_;
    file_.error(1, DiagnosticText{"NPOS states "} << npos_[i] << " positions " << kPositionNames[i] << ", the file has "
                                                  << counted_[i]);
  }
}

}  // namespace armature::job
