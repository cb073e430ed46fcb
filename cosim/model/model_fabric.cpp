#include "cosim/model/model_fabric.hpp"

#include "cosim/fabric/pin_trace.hpp"
#include "cosim/model/bus.hpp"
#include "cosim/model/logic.hpp"

namespace armature::cosim::model {
namespace {

template <class Variant>
class ModelFabric final : public Fabric {
 public:
  void set_inputs(const SocInputs& inputs) override { logic_.set_inputs(inputs); }
  void set_master(const AxiMasterPins& pins) override { master_ = pins; }

  bool run(std::int64_t limit) override {
    const Cycles end = logic_.now() + Cycles{limit};
    while (logic_.now() < end) {
      const bool every_edge = bus_.is_active(master_) || wave_.is_open();
      const Cycles next = every_edge ? logic_.now() + Cycles{1} : logic_.wakes_at();
      if (next > end) {
        logic_.pass(end);
        return false;
      }
      logic_.pass(next - Cycles{1});
      const bool changed = edge();
      if (wave_.is_open()) wave_.dump(cycle(), logic_.inputs(), logic_.outputs());
      if (changed) return true;
    }
    return false;
  }

  void stand_still(std::int64_t cycles) override { stood_ += Cycles{cycles}; }
  void stop_clock_of(ClockGroup group) override {
    logic_.stop_clock_of(group);
    bus_.stop(Logic<Variant>::ports_of(group));
  }

  [[nodiscard]] const SocOutputs& outputs() const override { return logic_.outputs(); }
  [[nodiscard]] AxiSlavePins slave() const override { return bus_.pins(); }
  [[nodiscard]] Cycles cycle() const override { return logic_.now() + stood_; }

  void add_to_waves(const SoftwareSignals& signals) override { wave_.add(signals); }
  void open_wave(const std::filesystem::path& file, WaveFormat format) override { wave_.open(file, format); }
  void close_wave() override { wave_.close(); }

 private:
  bool edge() {
    if (!bus_.is_active(master_)) return logic_.edge();
    typename Logic<Variant>::Answers answers;
    const bool changed = logic_.edge(bus_.accesses(), answers);
    bus_.edge(logic_.now(), master_, answers);
    return changed;
  }

  Logic<Variant> logic_;
  Bus<Logic<Variant>::kBlocks> bus_{Variant::kBases};
  AxiMasterPins master_;
  Cycles stood_{};  // cycles without an edge
  PinTrace wave_;
};

}  // namespace

std::unique_ptr<Fabric> make_model_fabric(Variant variant) {
  if (variant == Variant::kPaper) return std::make_unique<ModelFabric<PaperVariant>>();
  return std::make_unique<ModelFabric<CountsVariant>>();
}

}  // namespace armature::cosim::model
