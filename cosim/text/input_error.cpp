#include "cosim/text/input_error.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "cosim/text/printable.hpp"

namespace armature::cosim {
namespace {

constexpr std::size_t kMaxOfMessage = 2000;  // characters; names of files are no longer than the system allows

std::string join_lines(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    if (!text.empty()) text += '\n';
    text += problem.text();
  }
  return text;
}

}  // namespace

std::string place_text(const std::string& file, const Origin& origin) {
  if (!origin.override_text.empty()) return "--set " + printable(origin.override_text.str());
  std::string text = printable(file, kMaxOfMessage);
  if (origin.line > 0) text.append(":").append(std::to_string(origin.line));
  if (origin.line > 0 && origin.column > 0) text.append(":").append(std::to_string(origin.column));
  return text;
}

std::string Problem::text() const {
  std::string text = place_text(file, origin);
  if (!key.empty()) text.append(": ").append(printable(key));
  return text.append(": ").append(printable(message, kMaxOfMessage));
}

InputError::InputError(std::vector<Problem> problems)
    : std::runtime_error{join_lines(problems)}, problems_{std::move(problems)} {}

InputError::InputError(const Problem& problem) : InputError{std::vector<Problem>{problem}} {}

InputError::InputError(const std::string& file, const std::string& message)
    : InputError{Problem{file, Origin{}, std::string{}, message}} {}

void ProblemList::add(const Origin& origin, std::string_view key, std::string message) {
  if (++size_ <= kMaxKept) problems_.push_back({file_, origin, std::string{key}, std::move(message)});
}

void ProblemList::move_to(std::vector<Problem>& all) {
  const auto place = [](const Problem& p) {
    return std::tuple{!p.origin.override_text.empty(), p.origin.line, p.origin.column};
  };
  std::stable_sort(problems_.begin(), problems_.end(),
                   [&](const Problem& a, const Problem& b) { return place(a) < place(b); });
  std::move(problems_.begin(), problems_.end(), std::back_inserter(all));
  if (size_ > kMaxKept) {
    all.push_back({file_, Origin{}, {}, "and " + std::to_string(size_ - kMaxKept) + " more problems"});
  }
  problems_.clear();
  size_ = 0;
}

}  // namespace armature::cosim
