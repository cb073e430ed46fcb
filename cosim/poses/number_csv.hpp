// Comma-separated numbers under a fixed header, as users and spreadsheets write them.
//
// Also accepted: a byte order mark, CR LF, blanks around a number, a leading '+', empty lines at the end. Not accepted:
// quotes, comments, other separators, empty lines between rows, "nan", "inf", hexadecimal.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cosim/text/input_error.hpp"

namespace armature::cosim {

// The whole text as a decimal number, independent of the locale. Nullopt for other texts and for numbers that are not
// finite doubles.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

struct CsvColumn {
  std::string name;
  double largest = 0;       // of the absolute value
  std::string_view unit{};  // for messages
};
using CsvLayout = std::vector<CsvColumn>;

// `a,b,c`.
[[nodiscard]] std::string header_of(const CsvLayout& layout);

// The problems of one file. The first kMaxReported are kept, the others are only counted.
class CsvProblems {
 public:
  static constexpr std::size_t kMaxReported = 20;

  explicit CsvProblems(std::string file) : file_{std::move(file)} {}
  void add(int line, int column, std::string_view key, std::string message);
  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  // Throws InputError when there is a problem. The last line gives the number of problems that are not shown.
  void throw_if_any();

 private:
  std::string file_;
  std::vector<Problem> kept_;
  std::size_t count_ = 0;
};

struct NumberRow {
  std::size_t index = 0;  // from 0
  int line = 0;           // in the file; the header is line 1
  std::span<const double> values;
  std::span<const int> columns;  // of each value's first character in the line, from 1, in code points
};

// Reads `text`, whose header must be that of one of `layouts`, and calls visit(row, problems) for every row that has as
// many numbers as the header, each inside its range. Returns the index of the layout. Throws InputError with every
// problem of the file `name`, also those that `visit` added. If the header is wrong, nothing else is read.
using VisitRow = std::function<void(const NumberRow&, CsvProblems&)>;
std::size_t read_number_csv(std::string_view text, const std::string& name, std::span<const CsvLayout> layouts,
                            const VisitRow& visit);

}  // namespace armature::cosim
