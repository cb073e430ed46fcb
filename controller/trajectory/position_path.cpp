#include "controller/trajectory/position_path.hpp"
