// The parts of the module, each in a unit of its own: reading pybind11 takes long.
#pragma once

#include <pybind11/pybind11.h>

namespace armature::cosim {

// Run and Snapshot, whose Scenario the module has already.
void add_run(pybind11::module_& module);

}  // namespace armature::cosim
