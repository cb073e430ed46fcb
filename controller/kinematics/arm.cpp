#include "controller/kinematics/arm.hpp"
