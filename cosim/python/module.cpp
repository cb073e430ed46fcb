// The part of the module `armature` that is in C++: names, arrays and exceptions of Python for cosim/steer. The Python
// files beside it say what each function does.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "controller/base/words.hpp"
#include "controller/message/telemetry.hpp"
#include "controller/policy/policy_network.hpp"
#include "cosim/python/bindings.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "cosim/text/input_error.hpp"

namespace py = pybind11;

namespace armature::cosim {
namespace {

// ---- scenarios

template <class Enum>
std::optional<Enum> chosen(const char* name, const std::optional<std::string>& word) {
  if (!word) return std::nullopt;
  const std::optional<Enum> found = enumerator_of<Enum>(*word);
  if (!found) throw InputError{name, "unknown word: " + *word};
  return found;
}

std::shared_ptr<Scenario> load(const std::filesystem::path& where, std::vector<std::string> set,
                               const std::optional<std::string>& engine, const std::optional<std::string>& variant,
                               const std::vector<std::filesystem::path>& search) {
  LoadOptions options{.overrides = std::move(set)};
  for (const std::filesystem::path& folder : search) options.search_path.add({.path = folder, .origin = "search"});
  options.logic = {.variant = chosen<Variant>("variant", variant), .engine = chosen<Engine>("engine", engine)};
  return std::make_shared<Scenario>(load_scenario(where, options));
}

py::list axes_of(const Scenario& scenario) {
  py::list axes;
  for (std::size_t i = 0; i < scenario.robot.axis_count; ++i) {
    const AxisSpec& axis = scenario.robot.axes.at(i);
    py::dict facts;
    facts["min_deg"] = axis.min_deg;
    facts["max_deg"] = axis.max_deg;
    facts["max_speed_deg_s"] = axis.max_speed_deg_s;
    facts["max_accel_deg_s2"] = axis.max_accel_deg_s2;
    axes.append(facts);
  }
  return axes;
}

// ---- the module

py::list problems_of(const InputError& error) {
  py::list problems;
  for (const Problem& problem : error.problems()) {
    py::dict facts;
    facts["file"] = problem.file;
    facts["line"] = problem.origin.line;
    facts["column"] = problem.origin.column;
    facts["key"] = problem.key;
    facts["message"] = problem.message;
    facts["text"] = problem.text();
    problems.append(facts);
  }
  return problems;
}

void add_errors(py::module_& module) {
  // The module lives as long as the process.
  static const py::handle kType = py::exception<InputError>{module, "InputError", PyExc_ValueError}.release();
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(std::move(thrown));
    } catch (const InputError& error) {
      const py::object object = kType(error.what());
      object.attr("problems") = problems_of(error);
      PyErr_SetObject(kType.ptr(), object.ptr());
    }
  });
}

// ---- networks

using Words = py::array_t<std::uint32_t, py::array::c_style>;
using Bytes = py::array_t<std::int8_t, py::array::c_style>;

std::span<const std::uint32_t> span_of(const Words& words) {
  return {words.data(), static_cast<std::size_t>(words.size())};
}

Bytes evaluate_network(const Words& image, const Bytes& inputs, std::uint8_t bound) {
  const std::optional<PolicyNetwork> network = PolicyNetwork::decode(span_of(image));
  if (!network) throw py::value_error{"the image has more layers than fit, or no end"};
  if (inputs.ndim() != 2 || inputs.shape(1) > static_cast<py::ssize_t>(PolicyNetwork::kMostInputs)) {
    throw py::value_error{"expected rows of at most 32 inputs"};
  }
  const auto width = static_cast<std::size_t>(inputs.shape(1));
  const auto rows = static_cast<std::size_t>(inputs.shape(0));
  Bytes outputs{{rows, PolicyNetwork::kMostOutputs}};
  for (std::size_t row = 0; row < rows; ++row) {
    const PolicyNetwork::Outputs result = network->evaluate({inputs.data() + row * width, width}, bound);
    std::ranges::copy(result, outputs.mutable_data() + row * PolicyNetwork::kMostOutputs);
  }
  return outputs;
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  add_errors(module);
  py::class_<Scenario, std::shared_ptr<Scenario>>(module, "Scenario")
      .def(py::init(&load), py::arg("where"), py::kw_only(), py::arg("set") = std::vector<std::string>{},
           py::arg("engine") = py::none(), py::arg("variant") = py::none(),
           py::arg("search") = std::vector<std::filesystem::path>{})
      .def_readonly("name", &Scenario::name)
      .def_readonly("file", &Scenario::file)
      .def_readonly("description", &Scenario::description)
      .def_readonly("duration_s", &Scenario::duration_s)
      .def_readonly("seed", &Scenario::seed)
      .def_property_readonly("engine", [](const Scenario& of) { return std::string{word_of(of.engine)}; })
      .def_property_readonly("golden_sha256", [](const Scenario& of) { return of.golden.sha256; })
      .def_property_readonly("axes", &axes_of);
  add_run(module);
  module.def("network_checksum", [](const Words& image) { return PolicyNetwork::checksum(span_of(image)); });
  module.def("evaluate_network", &evaluate_network);
  py::list states;
  for (const std::string_view word : kWordsOf<MotionState>) states.append(std::string{word});
  module.attr("STATES") = py::tuple(states);
}

}  // namespace armature::cosim
