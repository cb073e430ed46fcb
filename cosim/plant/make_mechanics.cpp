#include "cosim/plant/make_mechanics.hpp"

#include "cosim/plant/independent_axes.hpp"

namespace armature::cosim {

std::unique_ptr<Mechanics> make_mechanics(const RobotSpec& robot) {
  return std::make_unique<IndependentAxes>(robot);
}

}  // namespace armature::cosim
