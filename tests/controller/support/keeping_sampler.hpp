// A sampler that keeps a copy of the plan that it executes.
#pragma once

#include <memory>

#include "controller/trajectory/run/sampler.hpp"

namespace armature::test {

class KeepingSampler : public Sampler {
 public:
  using Sampler::Sampler;
  template <class Plan>
  void start(const Plan& plan, double rate) {
    *plan_ = plan;
    Sampler::start(*plan_, rate);
  }
  void start(const RetargetPlan& plan) {
    *plan_ = plan;
    start_in_motion(*plan_);
  }

 private:
  std::unique_ptr<MotionPlan> plan_ = std::make_unique<MotionPlan>();
};

}  // namespace armature::test
