#include "cosim/text/suggest.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <limits>
#include <vector>

namespace armature::cosim {
namespace {

std::string lower_case(std::string_view text) {
  std::string lower{text};
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

// Optimal string alignment distance: insert, delete, replace, swap of neighbours.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replace});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

// `target` and `target_mm` both mean `target_deg`: the words before the unit agree.
bool same_stem(std::string_view typed, std::string_view name) {
  const auto stem = [](std::string_view text) { return text.substr(0, text.rfind('_')); };
  return typed.size() >= 2 && (typed == stem(name) || (stem(typed).size() >= 4 && stem(typed) == stem(name)));
}

}  // namespace

std::string_view nearest_name(std::string_view typed, std::span<const std::string_view> known) {
  constexpr std::size_t kLongest = 100;  // no name is nearly as long; the time grows with it
  if (typed.size() > kLongest) return {};
  const std::string typed_lower = lower_case(typed);
  std::string_view best;
  std::size_t best_distance = std::numeric_limits<std::size_t>::max();
  for (const std::string_view name : known) {
    const std::string name_lower = lower_case(name);
    const std::size_t distance = edit_distance(typed_lower, name_lower);
    const bool near = distance <= std::max<std::size_t>(1, std::max(typed.size(), name.size()) / 3);
    if ((near || same_stem(typed_lower, name_lower)) && distance < best_distance) {
      best = name;
      best_distance = distance;
    }
  }
  return best;
}

std::string suggestion(std::string_view typed, std::span<const std::string_view> known) {
  if (const std::string_view name = nearest_name(typed, known); !name.empty()) {
    return ", did you mean " + std::string{name} + "?";
  }
  std::string list;
  for (const std::string_view name : known) list += (list.empty() ? "; known: " : ", ") + std::string{name};
  return list;
}

std::string suggestion(std::string_view typed, std::span<const std::string> known) {
  const std::vector<std::string_view> names{known.begin(), known.end()};
  return suggestion(typed, std::span{names});
}

}  // namespace armature::cosim
