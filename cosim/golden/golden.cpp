#include "cosim/golden/golden.hpp"

#include <optional>
#include <system_error>

#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/scenario/toml/config_value.hpp"
#include "cosim/scenario/toml/override.hpp"
#include "cosim/scenario/toml/toml_document.hpp"
#include "cosim/text/byte_order_mark.hpp"
#include "cosim/text/text_file.hpp"
#include "cosim/trace/compare.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

// Byte offset of a position that the TOML parser reports in lines and code points.
std::size_t offset_of(std::string_view text, const Origin& origin) {
  std::size_t offset = text.size() - without_byte_order_mark(text).size();  // which the parser does not count
  for (int line = 1; line < origin.line; ++line) offset = text.find('\n', offset) + 1;
  const auto continues_code_point = [&](std::size_t i) {
    return i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U;
  };
  for (int column = 1; column < origin.column; ++column) {
    do {
      ++offset;
    } while (continues_code_point(offset));
  }
  return offset;
}

std::string edit(const std::string& text, const ConfigValue& document, const std::string& sha256) {
  const std::string newline = text.find("\r\n") == std::string::npos ? "\n" : "\r\n";
  const std::string literal = "\"" + sha256 + "\"";
  const ConfigEntry* golden = document.find("golden");
  std::string edited = text;
  if (golden == nullptr) {
    if (!edited.empty() && !edited.ends_with('\n')) edited += newline;
    edited += newline + "# Digest of every tick. `armature bless` writes it and golden.csv." + newline + "[golden]" +
              newline + "sha256 = " + literal + newline;
  } else if (const ConfigEntry* digest = golden->value.find("sha256")) {
    const std::size_t begin = offset_of(text, digest->value.origin);
    const std::size_t end = text.find(text[begin], begin + 1);  // the closing quote
    if (end != std::string::npos) edited.replace(begin, end + 1 - begin, literal);
  } else {
    const std::size_t line_end = text.find('\n', offset_of(text, golden->value.origin));
    const std::string line = "sha256 = " + literal + newline;
    edited = line_end == std::string::npos ? text + newline + line : edited.insert(line_end + 1, line);
  }
  return edited;
}

}  // namespace

std::string with_golden_sha256(const std::string& text, const std::string& file, const std::string& sha256) {
  ConfigValue wanted = parse_toml(text, file);
  std::string edited = edit(text, wanted, sha256);
  // The edit is textual. Parsing the result checks that it changed the digest and nothing else.
  ProblemList problems{file};
  apply_override(wanted, "golden.sha256=\"" + sha256 + "\"", problems);
  constexpr const char* kAdvice = "cannot set golden.sha256 in place; write it as a table [golden] with sha256 = \"\"";
  try {
    if (problems.size() > 0 || !same_content(parse_toml(edited, file), wanted)) throw InputError{file, kAdvice};
  } catch (const InputError&) {
    throw InputError{file, kAdvice};
  }
  return edited;
}

std::string_view GoldenCheck::word() const {
  static constexpr std::string_view kWords[] = {"none", "equal", "differs", "not compared"};
  return kWords[static_cast<std::size_t>(verdict)];
}

fs::path golden_file(const Scenario& scenario) {
  return fs::path{scenario.file}.parent_path() / kGoldenFile;
}

std::string run_argument(const Scenario& scenario) {
  const fs::path file{scenario.file};
  if (file.filename() != kScenarioFile) return file.string();
  return file.has_parent_path() ? file.parent_path().string() : ".";
}

std::string bless_golden(const Scenario& scenario, const fs::path& trace, const std::string& sha256) {
  const fs::path golden = golden_file(scenario);
  std::error_code ignored;
  std::string change = scenario.name + ": ";
  if (!fs::exists(golden, ignored)) {
    change += "new golden\n";
  } else {
    // The old golden is overwritten, so messages name no lines of it. The lines of the trace are those of the new
    // golden.
    const TraceName before{.file = {}, .value = "golden before"};
    const Comparison comparison = compare_traces(golden, trace, before, {.file = golden.string(), .value = "this run"});
    if (comparison.equal() && scenario.golden.sha256 == sha256) {
      change += "golden unchanged";
      if (comparison.rows_between > 0)
        change += "; golden.csv now has a row for every " + std::to_string(kGoldenEveryTicks) + " ticks";
      change += "\n";
    } else if (comparison.equal()) {
      change += comparison.other_cycles ? "golden changed: the triggers come at other clock cycles\n"
                                        : "golden changed only between the rows of golden.csv\n";
    } else if (comparison.equal_but_for_version()) {
      change += "golden changed only in its digest, which had an earlier version\n";
    } else {
      change += "golden changed: " + comparison.counts() + "\n" + comparison.details();
    }
  }
  const fs::path file{scenario.file};
  const std::string text = read_text_file(file);
  const std::string edited = with_golden_sha256(text, file.string(), sha256);
  replace_text_file(golden, read_text_file(trace));
  if (edited != text) replace_text_file(file, edited);
  if (scenario.golden.sha256 != sha256) {
    change += "  golden.sha256: " + scenario.golden.sha256.value_or("none") + " -> " + sha256 + "\n";
  }
  return change;
}

}  // namespace armature::cosim
