#include "controller/kinematics/six_r.hpp"
