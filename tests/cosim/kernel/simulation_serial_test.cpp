// The serial line inside a whole simulation: its pins, its events, its report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "cosim/fabric/fabric_wrapper.hpp"
#include "cosim/fabric/verilated_fabric.hpp"
#include "cosim/kernel/scenario_soc.hpp"
#include "cosim/kernel/simulation.hpp"
#include "cosim/scenario/files/scenario_loader.hpp"
#include "tests/support/pin_soc.hpp"
#include "tests/support/silent_listener.hpp"

namespace armature::cosim {
namespace {

class SerialRecorder final : public test::SilentListener {
 public:
  void on_row(TraceRow& row) override { rows.push_back(row); }
  void on_signal(const Signal& signal, Cycles) override {
    if (const auto* event = std::get_if<SerialEvent>(&signal)) serial.push_back(*event);
  }

  [[nodiscard]] std::string text(SerialDirection direction) const {
    std::string all;
    for (const SerialEvent& event : serial) {
      if (event.direction == direction) all += static_cast<char>(event.byte);
    }
    return all;
  }

  std::vector<TraceRow> rows;
  std::vector<SerialEvent> serial;
};

// The real logic, and a wire from the receive pin to the transmit pin with one flop in it.
class WiredFabric final : public FabricWrapper {
 public:
  WiredFabric() : FabricWrapper{make_verilated_fabric()} {}
  void set_inputs(const SocInputs& inputs) override {
    inner().set_inputs(inputs);
    rxd_ = inputs.uart_rxd;
  }
  bool run(std::int64_t limit) override {
    const bool moved = rxd_ != outputs_.uart_txd;
    const bool changed = inner().run(moved ? 1 : limit);
    outputs_ = inner().outputs();
    outputs_.uart_txd = rxd_;
    return changed || moved;
  }
  [[nodiscard]] const SocOutputs& outputs() const override { return outputs_; }

 private:
  SocOutputs outputs_;
  bool rxd_ = true;
};

class Peer final : public SerialPeer {
 public:
  void exchange(Cycles, std::size_t room, std::vector<std::uint8_t>& in) override {
    for (; room > 0 && !waiting.empty(); --room, waiting.pop_front()) in.push_back(waiting.front());
  }
  void send(std::uint8_t byte) override { got += static_cast<char>(byte); }
  std::deque<std::uint8_t> waiting;
  std::string got;
};

Scenario short_run() {
  const std::filesystem::path scenarios = ARMATURE_SOURCE_DIR "/scenarios";
  Scenario scenario = load_scenario(scenarios / "fig9_joint_move", {.search_path = scenarios, .overrides = {}});
  scenario.duration_s = 0.01;
  scenario.moves.front().at_s = 0.002;
  scenario.moves.front().kind = JointSpec{.target_deg = PerAxis<double>{0.02, -0.02, 0.01, 0.01, -0.01, 0.02}};
  return scenario;
}

Scenario with_serial(const std::string& text) {
  Scenario scenario = short_run();
  scenario.serial.emplace();
  SerialSendSpec send;
  send.at_s = 0.001;
  send.bytes = text;
  if (!text.empty()) scenario.serial_sends.push_back(send);
  return scenario;
}

TEST(SimulationSerial, WhatTheScriptSendsComesBackOverTheWire) {
  SerialRecorder recorder;
  const Scenario scenario = with_serial("armature");
  const SimulationEnd end =
      test::run_to_end(Simulation{scenario, test::pin_soc(std::make_unique<WiredFabric>()), recorder});
  EXPECT_EQ(end.reason, EndReason::kFinished) << end.failure;
  EXPECT_EQ(recorder.text(SerialDirection::kRx), "armature");
  EXPECT_EQ(recorder.text(SerialDirection::kTx), "armature");
  ASSERT_EQ(recorder.serial.front().at, Cycles{50'000});
  // 9.5 bits of 434.03 cycles and the flop of the wire.
  EXPECT_EQ(recorder.serial[1].at, Cycles{50'000 + 4'124 + 1});
  for (const SerialEvent& event : recorder.serial) EXPECT_FALSE(event.has_error());
}

TEST(SimulationSerial, APeerTalksOverTheWireWithItself) {
  SerialRecorder recorder;
  Peer peer;
  peer.waiting = {'e', 'c', 'h', 'o'};
  const Scenario scenario = with_serial("");
  test::run_to_end(Simulation{scenario, test::pin_soc(std::make_unique<WiredFabric>()), recorder, std::nullopt, &peer});
  EXPECT_EQ(peer.got, "echo");
}

TEST(SimulationSerial, TrafficOnTheLineDoesNotChangeTheMotion) {
  SerialRecorder quiet, busy;
  const Scenario without = short_run(), with = with_serial("a good deal of text");
  test::run_to_end(Simulation{without, make_soc(without), quiet});
  test::run_to_end(Simulation{with, make_soc(with), busy});
  EXPECT_TRUE(quiet.serial.empty());
  EXPECT_EQ(busy.text(SerialDirection::kRx), "a good deal of text");
  ASSERT_EQ(quiet.rows.size(), busy.rows.size());
  for (std::size_t i = 0; i < quiet.rows.size(); ++i) {
    ASSERT_EQ(quiet.rows[i].cycle, busy.rows[i].cycle);
    ASSERT_EQ(quiet.rows[i].pin_pulses, busy.rows[i].pin_pulses);
    ASSERT_EQ(quiet.rows[i].telemetry.encoder, busy.rows[i].telemetry.encoder);
  }
}

}  // namespace
}  // namespace armature::cosim
