#include "cosim/exports/npz_export.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "cosim/exports/npz_writer.hpp"
#include "cosim/trace/columns.hpp"

namespace armature::cosim {
namespace {

void write_column(NpzWriter& writer, const NumberColumn& column) {
  const bool whole = column.digits == 0 && std::ranges::find(column.values, NumberColumn::kNone) == column.values.end();
  if (whole) return writer.write(column.name, column.values);
  std::vector<double> numbers(column.values.size());
  for (std::size_t row = 0; row < numbers.size(); ++row) numbers[row] = column.number(row);
  writer.write(column.name, numbers);
}

std::vector<std::string> states_of(const TraceTable& trace) {
  std::vector<std::string> states;
  states.reserve(trace.rows());
  for (std::size_t i = 0; i < trace.states.size(); ++i) {
    const std::size_t end = i + 1 < trace.states.size() ? trace.states[i + 1].first_row : trace.rows();
    states.resize(end, trace.states[i].state);
  }
  return states;
}

}  // namespace

void export_npz(std::ostream& out, const RunRecord& run, const std::optional<TraceTable>& load) {
  NpzWriter writer{out};
  for (const NumberColumn& column : run.trace.columns) write_column(writer, column);
  if (!run.trace.states.empty()) writer.write(kStateColumn, states_of(run.trace));
  if (load) {
    for (const NumberColumn& column : load->columns) {
      if (run.trace.find(column.name) == nullptr) write_column(writer, column);
    }
  }
  writer.finish();
}

}  // namespace armature::cosim
