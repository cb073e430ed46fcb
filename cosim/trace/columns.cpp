#include "cosim/trace/columns.hpp"

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>

#include "controller/base/angle_units.hpp"
#include "cosim/text/names.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

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
  int digits;  // after the point
  Radians (*value)(const TraceRow&, std::size_t axis);
};
constexpr FloatColumn kFloatColumns[] = {
    {"ref_deg", kSetPointDigits, [](const TraceRow& row, std::size_t i) { return row.telemetry.reference[i]; }},
    {"enc_deg", kMeasuredDigits, [](const TraceRow& row, std::size_t i) { return row.telemetry.actual[i]; }},
};

constexpr std::size_t kMaxIntegerText = 20;  // of an int64
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

char* append(char* out, std::int64_t value) {
  return std::to_chars(out, out + kMaxIntegerText, value).ptr;
}

char* append(char* out, std::string_view text) {
  return out + text.copy(out, text.size());
}

char* append_fixed(char* out, double value, int digits) {
  // Beyond this a value is no valid angle or position. The limit also bounds the length of the text.
  constexpr double kLargest = 1e15;
  constexpr std::size_t kRoom = 32;
  if (!(std::fabs(value) < kLargest)) {
    return append(out, "nan");
  }
  char* end = std::to_chars(out, out + kRoom, value, std::chars_format::fixed, digits).ptr;
  // A negative value that rounds to zero is zero.
  if (*out == '-' && std::string_view{out, end}.find_first_not_of("-0.") == std::string_view::npos) {
    std::memmove(out, out + 1, static_cast<std::size_t>(end - out - 1));
    --end;
  }
  return end;
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
      out = append(out, column.value(row, axis));
    }
  }
  return out;
}

char* append_floats(char* out, const TraceRow& row) {
  const char* const begin = out;
  for (const FloatColumn& column : kFloatColumns) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (out != begin) *out++ = ',';
      out = append_fixed(out, column.value(row, axis).value() * kDegPerRad, column.digits);
    }
  }
  return out;
}

char* append_tool_point(char* out, const TraceRow& row) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const ToolPoint none{Eigen::Vector3d::Constant(kNone), Eigen::Vector3d::Constant(kNone)};
  const ToolPoint& point = row.tool_point ? *row.tool_point : none;
  const char* const begin = out;
  const auto append_point = [&](const Eigen::Vector3d& point_mm, int digits) {
    for (const double coordinate : point_mm) {
      if (out != begin) *out++ = ',';
      out = append_fixed(out, coordinate, digits);
    }
  };
  append_point(point.reference_mm, kSetPointDigits);
  append_point(point.encoder_mm, kMeasuredDigits);
  return out;
}

char* append_row(char* out, const TraceRow& row, std::string_view digest, ToolColumns tool_columns) {
  out = append(out, row.tick);
  *out++ = ',';
  out = append(out, seconds_text(Cycles{row.cycle}));
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
