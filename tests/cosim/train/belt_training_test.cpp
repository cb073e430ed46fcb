#include "cosim/train/belt_training.hpp"

#include <gtest/gtest.h>

#include "cosim/scenario/files/belt_policy_file.hpp"

namespace armature::cosim {
namespace {

const BeltTraining kShort{.belts = 6, .epochs = 4};

TEST(BeltTraining, LearnsMoreThanHalfOfTheCorrectionsOfItsBelts) {
  const TrainedBelt trained = train_belt(kShort);
  EXPECT_LT(trained.left_int8_rms_mm, 0.7 * trained.wanted_rms_mm);
  EXPECT_NEAR(trained.left_int8_rms_mm, trained.left_rms_mm, 0.05 * trained.wanted_rms_mm);
}

TEST(BeltTraining, MakesOtherBeltsCloserToWhatIsExpected) {
  const TrainedBelt trained = train_belt(kShort);
  const BeltErrors plain = belt_errors(99, 4, kShort.task, {}, {});
  const BeltErrors corrected = belt_errors(99, 4, kShort.task, {}, answer_of(trained.network));
  EXPECT_LT(corrected.rms_mm, 0.75 * plain.rms_mm);
}

// A target of a hand, seen by a camera.
TEST(BeltTraining, MakesTargetsOfAHandCloserToWhatIsExpected) {
  const BeltTraining training{.task = {.mm_per_count = 0.01, .full_mm = 5, .camera = BeltCameraSpec{}}, .belts = 10};
  const TrainedBelt trained = train_belt(training);
  const ConveyorBelt::Bandwidths own = bandwidths_of(training.task);
  const BeltErrors plain = belt_errors(99, 4, training.task, own, {});
  const BeltErrors corrected = belt_errors(99, 4, training.task, own, answer_of(trained.network));
  EXPECT_LT(corrected.rms_mm, 0.8 * plain.rms_mm);
  EXPECT_LT(corrected.unrest_mm_s2, 1.2 * plain.unrest_mm_s2);
}

// The answer of an example needs the future: with it, the expected belt is nearly the one that comes.
TEST(BeltTraining, TheWantedCorrectionsAreNoneOfABeltThatIsPredictedRight) {
  const BeltErrors plain = belt_errors(98, 2, {.mm_per_count = 0.001}, {.observer = 500, .second = 500}, {});
  EXPECT_LT(plain.rms_mm, 0.04);
  EXPECT_GT(plain.worst_mm, plain.rms_mm);
}

TEST(BeltTraining, ItsFileIsReadBack) {
  const TrainedBelt trained = train_belt({.belts = 1, .epochs = 1});
  const std::string text = policy_text(trained, "armature train");
  const BeltPolicyConfig read = parse_belt_policy(text, "n");
  EXPECT_EQ(read.image, trained.network.image);
  EXPECT_EQ(read.words, trained.network.words);
  EXPECT_EQ(read.crc, trained.network.crc);
  EXPECT_EQ(read.full_mm, trained.network.full_mm);
  for (std::size_t i = 0; i < read.inputs.size(); ++i) EXPECT_EQ(read.inputs[i].low, trained.network.inputs[i].low);
  EXPECT_EQ(policy_text(train_belt({.belts = 1, .epochs = 1}), "armature train"), text);
}

}  // namespace
}  // namespace armature::cosim
