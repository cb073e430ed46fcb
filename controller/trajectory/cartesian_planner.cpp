#include "controller/trajectory/cartesian_planner.hpp"
