#include "controller/trajectory/cartesian_plan.hpp"
