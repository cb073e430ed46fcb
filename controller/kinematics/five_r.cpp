#include "controller/kinematics/five_r.hpp"
