// Run and Snapshot for Python: cosim/steer.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cosim/python/bindings.hpp"
#include "cosim/report/format/json/summary_json.hpp"
#include "cosim/steer/steered_run.hpp"
#include "cosim/text/input_error.hpp"
#include "cosim/time/clock.hpp"
#include "cosim/time/never.hpp"

namespace py = pybind11;

namespace armature::cosim {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

// The values of an array, and 0 behind them. Throws InputError if they are not as many as asked for.
template <class Array>
Array values_of(const Numbers& numbers, std::size_t count, const char* name) {
  if (numbers.ndim() != 1 || static_cast<std::size_t>(numbers.size()) != count) {
    throw InputError{name, "expected " + std::to_string(count) + " numbers"};
  }
  Array values{};
  std::copy_n(numbers.data(), count, values.begin());
  return values;
}

Cycles cycles_of_ms(double ms) {
  constexpr double kLongest = 1e9;
  if (!(ms >= 0 && ms <= kLongest)) throw InputError{"advance", "expected 0 to 1e9 ms, found " + std::to_string(ms)};
  return to_cycles(ms * 1e-3);
}

// Read only. It keeps its memory itself, so it may outlive the run.
py::array view(const TraceColumns::Block& block, std::size_t rows) {
  using Memory = std::shared_ptr<void>;
  const py::capsule owner{new Memory{block.data}, [](void* memory) { delete static_cast<Memory*>(memory); }};
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows)};
  if (block.width > 1) shape.push_back(static_cast<py::ssize_t>(block.width));
  const bool real = block.type == TraceColumns::Type::kReal;
  py::array array{real ? py::dtype::of<double>() : py::dtype::of<std::int64_t>(), shape, block.data.get(), owner};
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

class PythonRun {
 public:
  PythonRun(const std::shared_ptr<Scenario>& scenario, std::optional<std::uint64_t> seed, std::int64_t every_ticks,
            bool compare_golden)
      : scenario_{*scenario}, options_{.every_ticks = every_ticks, .compare_golden = compare_golden} {
    if (every_ticks < 1) throw InputError{"every_ticks", "expected at least 1"};
    if (seed) scenario_.seed = *seed;
    run_ = std::make_unique<SteeredRun>(scenario_, options_);
  }

  // Other threads of Python continue meanwhile. Ctrl-C ends it between two steps.
  bool advance(Cycles duration) {
    constexpr Cycles kStep{100 * kTickCycles};
    const Use use{*this};
    Cycles rest = duration;
    do {
      const Cycles step = std::min(rest, kStep);
      const py::gil_scoped_release others_run;
      run_->advance(step);
      rest = rest - step;
    } while (rest > Cycles{} && !run_->over() && look_for_interrupt());
    return !run_->over();
  }

  void jog(const Numbers& joint_deg_s, double duration_s, double accel_percent) {
    const Use use{*this};
    const auto speeds = values_of<PerAxis<double>>(joint_deg_s, scenario_.robot.axis_count, "joint_deg_s");
    run_->jog({.joint_deg_s = speeds, .duration_s = duration_s, .accel_percent = accel_percent});
  }
  void jog_tool(const Numbers& mm_s, const Numbers& deg_s, double duration_s, const std::string& frame) {
    const Use use{*this};
    run_->jog({.tool_mm_s = values_of<std::array<double, 3>>(mm_s, 3, "mm_s"),
               .tool_deg_s = values_of<std::array<double, 3>>(deg_s, 3, "deg_s"),
               .frame_name = frame,
               .duration_s = duration_s});
  }
  void set_point(const Numbers& joints_deg, bool last, double delay_ms) {
    const Use use{*this};
    run_->send({.values = values_of<std::array<double, 6>>(joints_deg, scenario_.robot.axis_count, "joints_deg"),
                .last = last,
                .delay_ms = delay_ms});
  }
  void set_pose(const Numbers& xyz_mm_rpy_deg, bool last, double delay_ms) {
    const Use use{*this};
    run_->send({.kind = StreamSpec::Kind::kTool,
                .values = values_of<std::array<double, 6>>(xyz_mm_rpy_deg, 6, "xyz_mm_rpy_deg"),
                .last = last,
                .delay_ms = delay_ms});
  }

  py::array trace(const std::string& name) {
    const Use use{*this};
    const TraceColumns& trace = run_->trace();
    const auto found = std::ranges::find(trace.blocks(), name, &TraceColumns::Block::name);
    if (found == trace.blocks().end()) throw py::key_error{"no column " + name};
    return view(*found, trace.rows());
  }

  RunSnapshot snapshot() {
    const Use use{*this};
    return run_->snapshot();
  }
  // Arrays of the trace before keep their values.
  void restore(const RunSnapshot& snapshot) {
    const Use use{*this};
    const py::gil_scoped_release others_run;
    run_ = std::make_unique<SteeredRun>(scenario_, options_, snapshot);
    finished_ = false;
  }
  std::string finish() {
    const Use use{*this};
    if (std::exchange(finished_, true)) throw std::runtime_error{"the run is finished"};
    const py::gil_scoped_release others_run;
    return summary_json(run_->finish());
  }

  // What a property reads of the run.
  template <class Read>
  auto read(Read read) {
    const Use use{*this};
    return read(*run_);
  }

 private:
  // One thread at a time uses a run.
  class Use {
   public:
    explicit Use(PythonRun& run) : busy_{run.busy_} {
      if (busy_.exchange(true)) throw std::runtime_error{"another thread uses this run"};
    }
    ~Use() { busy_ = false; }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

   private:
    std::atomic<bool>& busy_;
  };

  static bool look_for_interrupt() {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set{};
    return true;
  }

  Scenario scenario_;
  SteeredRun::Options options_;
  std::unique_ptr<SteeredRun> run_;
  std::atomic<bool> busy_ = false;
  bool finished_ = false;
};

}  // namespace

void add_run(py::module_& module) {
  py::class_<RunSnapshot>(module, "Snapshot")
      .def_property_readonly("time_s", [](const RunSnapshot& snapshot) { return to_seconds(snapshot.at); })
      .def_property_readonly("sent", [](const RunSnapshot& snapshot) { return snapshot.sent.size(); });
  const auto property = [](auto read) { return [read](PythonRun& run) { return run.read(read); }; };
  py::class_<PythonRun>(module, "Run")
      .def(py::init<const std::shared_ptr<Scenario>&, std::optional<std::uint64_t>, std::int64_t, bool>(),
           py::arg("scenario"), py::kw_only(), py::arg("seed") = py::none(), py::arg("every_ticks") = 1,
           py::arg("compare_golden") = false)
      .def(
          "advance", [](PythonRun& run, double ms) { return run.advance(cycles_of_ms(ms)); }, py::arg("ms"))
      .def(
          "advance_ticks",
          [](PythonRun& run, std::uint32_t ticks) { return run.advance(Cycles{kTickCycles * std::int64_t{ticks}}); },
          py::arg("ticks"))
      .def("advance_to_end", [](PythonRun& run) { return run.advance(kNever); })
      .def("jog", &PythonRun::jog, py::arg("joint_deg_s"), py::arg("duration_s"), py::arg("accel_percent") = 100.0)
      .def("jog_tool", &PythonRun::jog_tool, py::arg("mm_s"), py::arg("deg_s"), py::arg("duration_s"),
           py::arg("frame") = "base")
      .def("set_point", &PythonRun::set_point, py::arg("joints_deg"), py::kw_only(), py::arg("last") = false,
           py::arg("delay_ms") = SetPoint{}.delay_ms)
      .def("set_pose", &PythonRun::set_pose, py::arg("xyz_mm_rpy_deg"), py::kw_only(), py::arg("last") = false,
           py::arg("delay_ms") = SetPoint{}.delay_ms)
      .def("trace", &PythonRun::trace, py::arg("column"))
      .def("snapshot", &PythonRun::snapshot)
      .def("restore", &PythonRun::restore, py::arg("snapshot"))
      .def("finish_json", &PythonRun::finish)
      .def_property_readonly("columns", property([](const SteeredRun& run) {
                               std::vector<std::string> names;
                               for (const auto& block : run.trace().blocks()) names.emplace_back(block.name);
                               return names;
                             }))
      .def_property_readonly("time_s", property([](const SteeredRun& run) { return to_seconds(run.now()); }))
      .def_property_readonly("over", property([](const SteeredRun& run) { return run.over(); }))
      .def_property_readonly("digest", property([](const SteeredRun& run) { return run.digest(); }))
      .def_property_readonly("refused", property([](const SteeredRun& run) { return run.refused(); }))
      .def_property_readonly("last_refusal",
                             property([](const SteeredRun& run) { return std::string{run.last_refusal()}; }));
}

}  // namespace armature::cosim
