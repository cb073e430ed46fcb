#include "cosim/train/belt_training.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <span>

#include "controller/activity/conveyor/belt_correction.hpp"
#include "controller/policy/policy_network.hpp"
#include "controller/policy/policy_scale.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/sha256.hpp"
#include "cosim/train/mlp.hpp"
#include "cosim/train/network_image.hpp"

namespace armature::cosim {
namespace {

using Inputs = std::array<double, BeltPolicyConfig::kInputs>;
constexpr std::array<std::size_t, 4> kSizes{BeltPolicyConfig::kInputs, 16, 16, 1};
constexpr std::size_t kBatch = 64;
constexpr double kRate = 3e-3;

// Those of the examples, 5 % wider, and symmetric but for the velocity.
void set_ranges(std::span<const BeltExample> examples, BeltPolicyConfig& network) {
  constexpr double kWider = 0.05;
  for (std::size_t i = 0; i < network.inputs.size(); ++i) {
    double low = examples[0].inputs[i], high = low;
    for (const BeltExample& example : examples) {
      low = std::min(low, example.inputs[i]);
      high = std::max(high, example.inputs[i]);
    }
    const double widest = std::max(std::fabs(low), std::fabs(high)) * (1 + kWider);
    const bool velocity = i + 1 == network.inputs.size();
    network.inputs[i] = {.low = velocity ? low - kWider * (high - low) : -widest, .high = widest};
  }
}

// The bytes of the inputs, from -1 to 1: the network is trained on what it will get.
std::vector<Inputs> scaled_inputs(std::span<const BeltExample> examples, const PolicyScale& scale) {
  std::vector<Inputs> all;
  all.reserve(examples.size());
  for (const BeltExample& example : examples) {
    const PolicyScale::Bytes bytes = scale.quantised(example.inputs).value_or(PolicyScale::Bytes{});
    Inputs& inputs = all.emplace_back();
    for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i] = bytes[i] / PolicyScale::kFull;
  }
  return all;
}

std::string digest_of_examples(std::span<const BeltExample> examples) {
  Sha256 sum;
  for (const BeltExample& example : examples) {
    for (const double value : example.inputs) sum.add(number_text(value) + ",");
    sum.add(number_text(example.correction_mm) + "\n");
  }
  return sum.hex();
}

Mlp trained_mlp(const BeltTraining& training, std::span<const BeltExample> examples, std::span<const Inputs> inputs,
                Random& random) {
  Mlp mlp{kSizes, random};
  const std::size_t steps = training.epochs * std::max<std::size_t>(1, examples.size() / kBatch);
  for (std::size_t step = 0; step < steps; ++step) {
    for (std::size_t i = 0; i < kBatch; ++i) {
      const std::size_t chosen = random.next() % examples.size();
      (void)mlp.evaluate(inputs[chosen]);
      mlp.add_gradient(examples[chosen].correction_mm / training.task.full_mm);
    }
    mlp.step(kBatch, kRate * (1 - static_cast<double>(step) / static_cast<double>(steps)));
  }
  return mlp;
}

// Of the inputs, of each hidden layer for all examples, and of the output.
std::vector<double> largest_values(Mlp& mlp, std::span<const Inputs> inputs) {
  std::vector<double> largest(kSizes.size(), 1e-6);
  for (const Inputs& values : inputs) {
    const auto& layers = mlp.evaluate(values);
    for (std::size_t l = 1; l + 1 < layers.size(); ++l)
      largest[l] = std::max(largest[l], *std::ranges::max_element(layers[l]));
  }
  largest.front() = largest.back() = 1;
  return largest;
}

template <class Answer>
double rms_left(std::span<const BeltExample> examples, const Answer& answer) {
  double sum = 0;
  for (std::size_t i = 0; i < examples.size(); ++i) {
    const double left_mm = answer(i) - examples[i].correction_mm;
    sum += left_mm * left_mm;
  }
  return std::sqrt(sum / static_cast<double>(examples.size()));
}

}  // namespace

BeltAnswer answer_of(const BeltPolicyConfig& network) {
  const auto image = std::make_shared<const std::array<std::uint32_t, BeltPolicyConfig::kMaxWords>>(network.image);
  const std::optional<PolicyNetwork> decoded = PolicyNetwork::decode(std::span{*image}.first(network.words));
  return [image, decoded, scale = scale_of(network)](const BeltObservation::Values& observation) {
    const auto bytes = scale.quantised(observation);
    if (!decoded || !bytes) return 0.0;
    return scale.correction(decoded->evaluate(std::span{*bytes}.first(scale.input_count), BeltPolicyConfig::kWhole))[0];
  };
}

TrainedBelt train_belt(const BeltTraining& training) {
  const double full_mm = training.task.full_mm;
  const std::vector<BeltExample> examples = belt_examples(training.seed, training.belts, training.task);
  TrainedBelt trained{
      .network = {.full_mm = full_mm}, .examples = examples.size(), .examples_sha256 = digest_of_examples(examples)};
  set_ranges(examples, trained.network);
  const std::vector<Inputs> inputs = scaled_inputs(examples, scale_of(trained.network));
  Random random{training.seed};
  Mlp mlp = trained_mlp(training, examples, inputs, random);
  const std::vector<std::uint32_t> image = network_image(mlp, largest_values(mlp, inputs));
  trained.network.crc = PolicyNetwork::checksum(image);
  trained.network.words = static_cast<std::uint32_t>(image.size());
  std::ranges::copy(image, trained.network.image.begin());

  trained.wanted_rms_mm = rms_left(examples, [](std::size_t) { return 0.0; });
  trained.left_rms_mm = rms_left(
      examples, [&](std::size_t i) { return full_mm * std::clamp(mlp.evaluate(inputs[i]).back()[0], -1.0, 1.0); });
  const BeltAnswer answer = answer_of(trained.network);
  trained.left_int8_rms_mm = rms_left(examples, [&](std::size_t i) { return answer(examples[i].inputs); });
  return trained;
}

std::string policy_text(const TrainedBelt& trained, const std::string& command) {
  constexpr std::size_t kWordsInALine = 8;
  const BeltPolicyConfig& network = trained.network;
  std::string text = fmt::format(
      "# A network that corrects where a belt is expected, for [conveyor.policy]. Made by:\n#   {}\n"
      "# {} examples, sha256 {}\n"
      "# rms of the corrections that they want {:.5f} mm; the network leaves {:.5f} mm of them, with doubles {:.5f} "
      "mm\n",
      command, trained.examples, trained.examples_sha256, trained.wanted_rms_mm, trained.left_int8_rms_mm,
      trained.left_rms_mm);
  text += fmt::format("full_mm {}\n", number_text(network.full_mm));
  for (const BeltPolicyConfig::Range& range : network.inputs) {
    text += fmt::format("input {} {}\n", number_text(range.low), number_text(range.high));
  }
  text += fmt::format("crc {:08x}\n", network.crc);
  for (std::size_t i = 0; i < network.words; ++i) {
    text += fmt::format("{} {:08x}{}", i % kWordsInALine == 0 ? "image" : "", network.image[i],
                        i % kWordsInALine + 1 == kWordsInALine || i + 1 == network.words ? "\n" : "");
  }
  return text;
}

}  // namespace armature::cosim
