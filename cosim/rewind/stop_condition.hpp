// What a ReversibleRun can stop at: a class derived from StopCondition, which listens to the run.
#pragma once

#include <optional>

#include "cosim/run/run_listener.hpp"

namespace armature::cosim {

class StopCondition : public RunListener {
 public:
  // The cycle in which the condition was met first since begin().
  [[nodiscard]] std::optional<Cycles> met() const { return met_; }
  void begin() { met_.reset(); }

 protected:
  // To be called by the functions of RunListener.
  void meet(Cycles at) {
    if (!met_) met_ = at;
  }

 private:
  std::optional<Cycles> met_;
};

}  // namespace armature::cosim
