#include "controller/trajectory/time_law.hpp"
