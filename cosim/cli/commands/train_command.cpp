#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "cosim/cli/command/command.hpp"
#include "cosim/cli/options/output_files.hpp"
#include "cosim/cli/options/value_kinds.hpp"
#include "cosim/text/number_text.hpp"
#include "cosim/text/text_file.hpp"
#include "cosim/train/belt_training.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTrainDetails = R"(Examples:
  armature train --belts 2 --epochs 1 --test 2
  armature train --belts 2 --epochs 1 --test 0 --out belt.policy
  armature train --belts 2 --epochs 1 --test 2 --camera --full-mm 5

Trains the network of [conveyor.policy]: 10 inputs, two layers of 16 neurons, one output. It learns to correct where the
controller expects a belt, from belts whose speed changes. The same options give the same bytes on every machine.
The table shows, for belts that the network has not seen, how far the expected belt is from the one that comes, and how restless
it is while the belt has a constant speed. 'tuned' is the best choice of the two bandwidths of the controller that is no more
restless than the network.
Exit code: 0 ok, 2 bad input.)";

struct TrainOptions {
  BeltTraining training;
  bool sees_hand = false;
  BeltCameraSpec camera;
  std::size_t test = 100;
  std::optional<fs::path> out;
};

// In the command line: all of it, or nothing.
std::string camera_options(const std::optional<BeltCameraSpec>& camera) {
  if (!camera) return {};
  return fmt::format(" --camera --period-ms {} --dead-time-ms {} --noise-mm {}", number_text(camera->period_ms),
                     number_text(camera->dead_time_ms), number_text(camera->noise_mm));
}

std::string error_row(const std::string& name, const BeltErrors& errors) {
  return fmt::format("  {:<26} {:>9.4f} {:>9.4f} {:>12.0f}\n", name, errors.rms_mm, errors.worst_mm,
                     errors.unrest_mm_s2);
}

// The best bandwidths that are no more restless.
std::string tuned_row(const TrainOptions& given, std::uint64_t seed, double most_unrest) {
  // Multiples of its own.
  constexpr std::array kObserver{0.75, 1.0, 1.25, 1.5, 2.0, 2.5};
  constexpr std::array kSecond{1.0, 1.5, 2.0, 3.0};
  const ConveyorBelt::Bandwidths own = bandwidths_of(given.training.task);
  BeltErrors best{.rms_mm = 1e9};
  ConveyorBelt::Bandwidths chosen;
  for (const double observer : kObserver) {
    for (const double second : kSecond) {
      const ConveyorBelt::Bandwidths bandwidths{.observer = observer * own.observer, .second = second * own.second};
      const BeltErrors errors = belt_errors(seed, given.test, given.training.task, bandwidths, {});
      if (errors.unrest_mm_s2 > most_unrest || errors.rms_mm >= best.rms_mm) continue;
      best = errors;
      chosen = bandwidths;
    }
  }
  return error_row(fmt::format("tuned: {:.0f} and {:.0f} /s", chosen.observer, chosen.second), best);
}

std::string error_table(const TrainOptions& given, const BeltPolicyConfig& network) {
  const BeltTask& task = given.training.task;
  const std::uint64_t seed = ~given.training.seed;
  const ConveyorBelt::Bandwidths own = bandwidths_of(task);
  const BeltErrors plain = belt_errors(seed, given.test, task, own, {});
  const BeltErrors corrected = belt_errors(seed, given.test, task, own, answer_of(network));
  return fmt::format("{} other belts                   rms mm  worst mm  unrest mm/s2\n", given.test) +
         error_row(fmt::format("controller: {:.0f} and {:.0f} /s", own.observer, own.second), plain) +
         tuned_row(given, seed, corrected.unrest_mm_s2) + error_row("controller and network", corrected);
}

std::string command_of(const BeltTraining& training) {
  return fmt::format("armature train --seed {} --belts {} --epochs {} --mm-per-count {} --lead-ms {} --full-mm {}{}",
                     training.seed, training.belts, training.epochs, number_text(training.task.mm_per_count),
                     number_text(training.task.lead_ms), number_text(training.task.full_mm),
                     camera_options(training.task.camera));
}

int train_network(const TrainOptions& given) {
  OutputFiles files;
  if (given.out) files.writes(*given.out, "--out", Writing::kReplaced);
  const TrainedBelt trained = train_belt(given.training);
  std::cout << fmt::format("{} examples: rms of the corrections {:.5f} mm, left by the network {:.5f} mm\n",
                           trained.examples, trained.wanted_rms_mm, trained.left_int8_rms_mm);
  if (given.out) replace_text_file(*given.out, policy_text(trained, command_of(given.training)));
  if (given.test > 0) std::cout << error_table(given, trained.network);
  return kExitOk;
}

void declare_camera(CLI::App& app, TrainOptions& options) {
  CLI::Option* hand =
      app.add_flag("--camera", options.sees_hand,
                   "Targets of 3 s that a hand moves to and fro and a camera measures, instead of belts");
  const auto add = [&](const char* name, double& value, const char* text, double low, double high) {
    app.add_option(name, value, text)->check(CLI::Range(low, high))->capture_default_str()->needs(hand);
  };
  add("--period-ms", options.camera.period_ms, "As the key of [conveyor.camera]", 0.05, 1'000.0);
  add("--dead-time-ms", options.camera.dead_time_ms, "As the key of [conveyor.camera]", 0.0, 1'000.0);
  add("--noise-mm", options.camera.noise_mm, "As the key of [conveyor.camera]", 0.0, 100.0);
}

CommandAction declare_train(CLI::App& app) {
  const auto options = std::make_shared<TrainOptions>();
  BeltTraining& training = options->training;
  app.add_option("--out", options->out, "Write the network to this file")->type_name(kFileValue);
  app.add_option("--seed", training.seed, "Seed of the belts and of the first weights")->capture_default_str();
  app.add_option("--belts", training.belts, "Belts of a second to learn from")
      ->check(CLI::Range(1, 10'000))
      ->capture_default_str();
  app.add_option("--epochs", training.epochs, "How often each example is seen on average")
      ->check(CLI::Range(1, 1'000))
      ->capture_default_str();
  app.add_option("--test", options->test, "Belts of a second to test with; 0: no test")
      ->check(CLI::Range(0, 10'000))
      ->capture_default_str();
  app.add_option("--mm-per-count", training.task.mm_per_count, "Distance for one count of the belt's encoder")
      ->check(CLI::Range(1e-4, 1.0))
      ->capture_default_str();
  app.add_option("--lead-ms", training.task.lead_ms, "Time by which the drives lag, as the key of [conveyor]")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  app.add_option("--full-mm", training.task.full_mm, "Largest correction")
      ->check(CLI::Range(1e-3, 10.0))
      ->capture_default_str();
  declare_camera(app, *options);
  return [options](const CommonOptions&) {
    if (options->sees_hand) options->training.task.camera = options->camera;
    return train_network(*options);
  };
}

}  // namespace

Subcommand train_command() {
  return {.name = "train",
          .order = 75,
          .summary = "Train the network that corrects where a belt is expected",
          .details = kTrainDetails,
          .declare = declare_train};
}

}  // namespace armature::cosim
