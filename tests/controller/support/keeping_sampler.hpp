// A sampler that keeps a copy of the plan that it executes.
#pragma once

#include <memory>

#include "controller/trajectory/run/sampler.hpp"

namespace armature::test {

class KeepingSampler : public Sampler {
 public:
  using Sampler::Sampler;
  template <class Whole>
  void start(const Whole& whole, double rate) {
    Sampler::start(Plan{kept_->keep(whole)}, rate);
  }
  void start(const RetargetPlan& plan) { start_in_motion(kept_->chain = plan); }

 private:
  std::unique_ptr<PieceStore> kept_ = std::make_unique<PieceStore>();
};

}  // namespace armature::test
