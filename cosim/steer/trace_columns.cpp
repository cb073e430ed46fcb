#include "cosim/steer/trace_columns.hpp"

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "controller/base/angle_units.hpp"
#include "controller/base/axes.hpp"
#include "controller/base/timebase.hpp"
#include "cosim/report/measure/tool_point.hpp"
#include "cosim/time/clock.hpp"

namespace armature::cosim {
namespace {

constexpr std::size_t kCoordinates = 3;

// Rows of the whole run. The first trigger comes after the start-up, so there are no more ticks than fit.
std::size_t room_for(const Scenario& scenario, std::int64_t every_ticks) {
  const double ticks = std::ceil(scenario.duration_s / kTickSeconds);
  return static_cast<std::size_t>(ticks / static_cast<double>(every_ticks)) + 2;
}

template <class Value, class Source>
void write(Value* row, const PerAxis<Source>& values, double scale = 1) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if constexpr (std::is_same_v<Source, std::int64_t>) {
      row[axis] = values[axis];
    } else if constexpr (std::is_same_v<Value, double>) {
      row[axis] = values[axis].value() * scale;
    } else {
      row[axis] = values[axis].value();
    }
  }
}

void write(double* row, const Eigen::Vector3d& values) {
  for (std::size_t i = 0; i < kCoordinates; ++i) row[i] = values[static_cast<Eigen::Index>(i)];
}

}  // namespace

template <class Value>
Value* TraceColumns::add(std::string_view name, std::size_t width) {
  const std::shared_ptr<Value[]> data = std::make_shared_for_overwrite<Value[]>(room_ * width);
  const Type type = std::is_same_v<Value, double> ? Type::kReal : Type::kInteger;
  blocks_.push_back({.name = name, .type = type, .width = width, .data = {data, data.get()}});
  return data.get();
}

TraceColumns::TraceColumns(const Scenario& scenario, std::int64_t every_ticks)
    : every_ticks_{every_ticks},
      room_{room_for(scenario, every_ticks)},
      tick_{add<std::int64_t>(kTickColumn, 1)},
      time_s_{add<double>(kTimeColumn, 1)},
      state_{add<std::int64_t>(kStateColumn, 1)},
      commanded_{add<std::int64_t>("cmd_pulses", kAxes)},
      pins_{add<std::int64_t>("pin_pulses", kAxes)},
      encoder_{add<std::int64_t>("enc_counts", kAxes)},
      correction_{add<std::int64_t>("corr_pulses", kAxes)},
      reference_deg_{add<double>("ref_deg", kAxes)},
      actual_deg_{add<double>("enc_deg", kAxes)} {
  if (tool_columns(scenario) == ToolColumns::kNo) return;
  tool_reference_mm_ = add<double>("tcp_ref_mm", kCoordinates);
  tool_actual_mm_ = add<double>("tcp_enc_mm", kCoordinates);
}

void TraceColumns::on_row(const TraceRow& row, const IntegerDigest&) {
  if (row.tick % every_ticks_ != 0) return;
  const std::size_t here = rows_;
  if (here == room_) throw std::logic_error{"the run has more ticks than its duration"};
  const Telemetry& telemetry = row.telemetry;
  tick_[here] = row.tick;
  time_s_[here] = to_seconds(Cycles{row.cycle});
  state_[here] = static_cast<std::int64_t>(telemetry.state);
  const std::size_t first = here * kAxes;
  write(commanded_ + first, telemetry.commanded);
  write(pins_ + first, row.pin_pulses);
  write(encoder_ + first, telemetry.encoder);
  write(correction_ + first, telemetry.correction);
  write(reference_deg_ + first, telemetry.reference, kDegPerRad);
  write(actual_deg_ + first, telemetry.actual, kDegPerRad);
  if (tool_reference_mm_ != nullptr) {
    const ToolPoint point = row.tool_point.value_or(
        ToolPoint{.reference_mm = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()),
                  .encoder_mm = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN())});
    write(tool_reference_mm_ + here * kCoordinates, point.reference_mm);
    write(tool_actual_mm_ + here * kCoordinates, point.encoder_mm);
  }
  rows_ = here + 1;
}

}  // namespace armature::cosim
