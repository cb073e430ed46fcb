#include "cosim/trace/columns.hpp"

#include <cmath>
#include <limits>
#include <string_view>

#include "controller/base/angle_units.hpp"
#include "cosim/text/names.hpp"
#include "cosim/time/clock.hpp"
#include "cosim/trace/decimal_text.hpp"

namespace armature::cosim {
namespace {

char* append(char* out, std::string_view text) {
  return out + text.copy(out, text.size());
}

template <int kDigits>
char* append_real(char* out, double value) {
  // Beyond this a value is no valid angle or position.
  return std::fabs(value) < kLargestFixed ? append_fixed<kDigits>(out, value) : append(out, "nan");
}

struct IntegerColumn {
  std::string_view suffix;
  std::int64_t (*value)(const TraceRow&, std::size_t axis);
};
constexpr IntegerColumn kIntegerColumns[] = {
    {"cmd_pulses", [](const TraceRow& row, std::size_t i) { return row.telemetry.commanded[i].value(); }},
    {"pin_pulses", [](const TraceRow& row, std::size_t i) { return row.pin_pulses[i]; }},
    {"enc_counts", [](const TraceRow& row, std::size_t i) { return row.telemetry.encoder[i].value(); }},
    {"corr_pulses", [](const TraceRow& row, std::size_t i) { return row.telemetry.correction[i].value(); }},
};

struct FloatColumn {
  std::string_view suffix;
  char* (*append)(char* out, double value);
  Radians (*value)(const TraceRow&, std::size_t axis);
};
constexpr FloatColumn kFloatColumns[] = {
    {"ref_deg", append_real<kSetPointDigits>,
     [](const TraceRow& row, std::size_t i) { return row.telemetry.reference[i]; }},
    {"enc_deg", append_real<kMeasuredDigits>,
     [](const TraceRow& row, std::size_t i) { return row.telemetry.actual[i]; }},
};

static_assert((std::size(kIntegerColumns) * kAxes + 2) * (kMaxIntegerText + 1) <= kMaxPartText);

// `jN_suffix` for each column and axis, with a comma before each name except the first.
template <class Column, std::size_t kCount>
void append_names(std::string& header, const Column (&columns)[kCount]) {
  for (const Column& column : columns) {
    for (std::size_t axis = 1; axis <= kAxes; ++axis) {
      if (!header.empty()) header += ',';
      header.append("j").append(std::to_string(axis)).append("_").append(column.suffix);
    }
  }
}

}  // namespace

bool is_digest(std::string_view column) {
  constexpr std::string_view kName = "digest";
  return column.starts_with(kName) &&
         column.substr(kName.size()).find_first_not_of("0123456789") == std::string_view::npos;
}

std::string integer_header() {
  std::string header{kStateColumn};
  append_names(header, kIntegerColumns);
  return header;
}

std::string float_header() {
  std::string header;
  append_names(header, kFloatColumns);
  return header;
}

std::string tool_point_header() {
  std::string header;
  for (const std::string_view side : {"ref", "enc"}) {
    for (const std::string_view coordinate : {"x", "y", "z"}) {
      if (!header.empty()) header += ',';
      header.append("tcp_").append(side).append("_").append(coordinate).append("_mm");
    }
  }
  return header;
}

std::string trace_header(ToolColumns tool_columns) {
  std::string header{kTickColumn};
  header.append(",").append(kTimeColumn).append(",").append(integer_header()).append(",").append(float_header());
  if (tool_columns == ToolColumns::kYes) header.append(",").append(tool_point_header());
  return header.append(",").append(kDigestColumn);
}

char* append_integers(char* out, const TraceRow& row) {
  out = append(out, word_of(row.telemetry.state));
  for (const IntegerColumn& column : kIntegerColumns) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      *out++ = ',';
      out = append_integer(out, column.value(row, axis));
    }
  }
  return out;
}

char* append_floats(char* out, const TraceRow& row) {
  const char* const begin = out;
  for (const FloatColumn& column : kFloatColumns) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (out != begin) *out++ = ',';
      out = column.append(out, column.value(row, axis).value() * kDegPerRad);
    }
  }
  return out;
}

char* append_tool_point(char* out, const TraceRow& row) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const ToolPoint none{Eigen::Vector3d::Constant(kNone), Eigen::Vector3d::Constant(kNone)};
  const ToolPoint& point = row.tool_point ? *row.tool_point : none;
  const char* const begin = out;
  const auto append_point = [&](const Eigen::Vector3d& point_mm, auto append_coordinate) {
    for (const double coordinate : point_mm) {
      if (out != begin) *out++ = ',';
      out = append_coordinate(out, coordinate);
    }
  };
  append_point(point.reference_mm, append_real<kSetPointDigits>);
  append_point(point.encoder_mm, append_real<kMeasuredDigits>);
  return out;
}

char* append_seconds(char* out, Cycles cycles) {
  static_assert(100'000'000 % kClkFreqHz == 0 && kTimeDigits == 8);
  return append_units<kTimeDigits>(out, static_cast<std::uint64_t>(cycles.value() * (100'000'000 / kClkFreqHz)));
}

char* append_row(char* out, const TraceRow& row, std::string_view digest, ToolColumns tool_columns) {
  out = append_integer(out, row.tick);
  *out++ = ',';
  out = append_seconds(out, Cycles{row.cycle});
  *out++ = ',';
  out = append_integers(out, row);
  *out++ = ',';
  out = append_floats(out, row);
  if (tool_columns == ToolColumns::kYes) {
    *out++ = ',';
    out = append_tool_point(out, row);
  }
  *out++ = ',';
  return append(out, digest);
}

}  // namespace armature::cosim
