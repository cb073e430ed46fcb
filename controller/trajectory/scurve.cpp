#include "controller/trajectory/scurve.hpp"
