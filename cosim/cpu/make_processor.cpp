#include "cosim/cpu/make_processor.hpp"

#include "cosim/cpu/fiber_processor.hpp"

namespace armature::cosim {

std::unique_ptr<Processor> make_processor(const RobotModel& robot, const ControllerConfig& config,
                                          const CpuSpec& spec) {
  return std::make_unique<FiberProcessor>(robot, config, spec);
}

}  // namespace armature::cosim
