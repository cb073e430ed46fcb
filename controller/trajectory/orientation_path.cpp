#include "controller/trajectory/orientation_path.hpp"
