#include "cosim/scenario/toml/toml_limits.hpp"

#include <algorithm>
#include <map>

#include "cosim/text/blanks.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

// One pass over the text. It recognises strings and comments, and counts the signs outside of them.
class Scan {
 public:
  Scan(std::string_view text, const std::string& file) : text_{text}, file_{file} {}

  void run() {
    bool line_begins = true;  // only blanks so far
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (line_begins && text_.substr(at_, 2) == "[[") count_table();
      line_begins = c == '\n' || (line_begins && (c == ' ' || c == '\t'));
      if (c == '"' || c == '\'') {
        skip_string(c);
      } else if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else {
        count(c);
        ++at_;
      }
    }
  }

 private:
  void count(char c) {
    if (c == '\n') ++line_;
    if (c == '.') {
      if (++dots_ >= kMaxKeyParts) {
        fail("expected keys of at most " + std::to_string(kMaxKeyParts) + " parts, joined by dots");
      }
    } else if (std::string_view{"\n=,[]{}"}.find(c) != std::string_view::npos) {
      dots_ = 0;
    }
    if ((c == '[' || c == '{') && ++depth_ > kMaxNestedValues) {
      fail("expected at most " + std::to_string(kMaxNestedValues) + " nested arrays and tables");
    }
    if ((c == ']' || c == '}') && depth_ > 0) --depth_;
    if (std::string_view{"=,[."}.find(c) != std::string_view::npos && ++values_ > kMaxTomlValues) {
      fail("expected at most " + std::to_string(kMaxTomlValues) + " values and parts of keys in a file");
    }
  }

  // At `[[`.
  void count_table() {
    const std::string_view kind =
        trimmed(text_.substr(at_ + 2, std::min(text_.find_first_of("]\n", at_), text_.size()) - at_ - 2));
    if (++tables_[kind] > kMaxTables) fail("expected " + at_most_tables(kMaxTables, kind));
  }

  // At a quote. A string of one line ends with the line at the latest: then the text is no TOML.
  void skip_string(char quote) {
    const std::string_view three = quote == '"' ? "\"\"\"" : "'''";
    const bool multi_line = text_.substr(at_).starts_with(three);
    at_ += multi_line ? 3 : 1;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\n') {
        if (!multi_line) return;
        ++line_;
      }
      if (c == '\\' && quote == '"') {
        const bool escapes = at_ + 1 < text_.size() && text_[at_ + 1] != '\n';
        at_ += escapes ? 2u : 1u;
      } else if (c != quote) {
        ++at_;
      } else if (!multi_line) {
        ++at_;
        return;
      } else if (text_.substr(at_).starts_with(three)) {
        at_ += 3;
        for (int more = 0; more < 2 && at_ < text_.size() && text_[at_] == quote; ++more) ++at_;  // of the string
        return;
      } else {
        ++at_;
      }
    }
  }

  [[noreturn]] void fail(std::string message) const {
    throw InputError{Problem{file_, Origin{line_, 0, {}}, {}, std::move(message)}};
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::size_t dots_ = 0;
  std::size_t depth_ = 0;
  std::size_t values_ = 0;
  std::map<std::string_view, std::size_t> tables_;
};

}  // namespace

std::string at_most_tables(std::size_t most, std::string_view kind) {
  return "at most " + std::to_string(most) + " tables [[" + printable(kind) + "]]";
}

void check_toml_limits(std::string_view text, const std::string& file) {
  if (text.size() > kMaxTomlBytes) {
    throw InputError{file, "is too large, expected at most " + std::to_string(kMaxTomlBytes >> 20U) + " MiB"};
  }
  Scan{text, file}.run();
}

}  // namespace armature::cosim
