#include "cosim/plant/make_mechanics.hpp"

#include <cstddef>
#include <optional>

#include "controller/base/angle_units.hpp"
#include "cosim/plant/clock.hpp"
#include "cosim/plant/independent_axes.hpp"
#include "cosim/servo/arm_model.hpp"
#include "cosim/servo/servo_arm.hpp"

namespace armature::cosim {
namespace {

// plant = "dynamic". All axes move in each step, because they act on each other.
class DynamicAxes final : public Mechanics {
 public:
  explicit DynamicAxes(const RobotSpec& robot)
      : arm_{servo_numbers(robot.axes, kPlantStepSeconds), arm_model(robot), kStepsOfTick} {}

  std::uint8_t step(std::uint8_t, const MotorDemands& demands, Shafts& shafts) override {
    arm_.step(demands.controlled, demands.reference, shafts.error, shafts.speed);
    return kAllAxes;
  }
  void block(std::size_t axis, bool on) override { arm_.block(axis, on); }
  bool weaken_brake(std::size_t axis, double share) override {
    arm_.weaken_brake(axis, share);
    return true;
  }
  bool push(std::size_t axis, double torque_nm) override {
    arm_.push(axis, torque_nm);
    return true;
  }
  [[nodiscard]] std::uint8_t overloaded() const override { return arm_.overloaded(); }
  void keep() override { arm_.keep(); }
  void take_back() override { arm_.take_back(); }
  [[nodiscard]] std::optional<PerAxis<double>> load_lead_deg() const override {
    return make_per_axis([&](std::size_t axis) { return arm_.twist_rad(axis) * -kDegPerRad; });
  }

 private:
  static constexpr int kStepsOfTick = static_cast<int>(armature::kTickCycles.value() / kPlantStep.value());

  ServoArm arm_;
};

}  // namespace

std::unique_ptr<Mechanics> make_mechanics(const RobotSpec& robot) {
  if (robot.plant == kDynamicPlant) return std::make_unique<DynamicAxes>(robot);
  return std::make_unique<IndependentAxes>(robot);
}

}  // namespace armature::cosim
