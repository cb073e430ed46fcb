#include "controller/kinematics/transform.hpp"
