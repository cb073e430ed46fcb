#include "cosim/plot/path_rows.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace armature::cosim {
namespace {

using Json = nlohmann::ordered_json;

Json path_move(int start, int ticks, bool rapid) {
  Json move = {{"start_tick", start}, {"duration_ticks", ticks}, {"taken_ticks", ticks}, {"path", Json::object()}};
  if (rapid) move["rapid"] = true;
  return move;
}

// A row for every tenth tick, from 0 to 90.
RunRecord run_with(Json moves) {
  RunRecord run;
  run.trace.columns = {{.name = "tick"}};
  for (std::int64_t tick = 0; tick < 100; tick += 10) run.trace.columns[0].values.push_back(tick);
  run.summary["result"]["moves"] = std::move(moves);
  return run;
}

// Such as "2-4 rapid, 4-7".
std::string text_of(const std::vector<PathRows>& pieces) {
  std::string text;
  for (const PathRows& piece : pieces) {
    text += (text.empty() ? "" : ", ") + std::to_string(piece.first) + "-" + std::to_string(piece.last);
    if (piece.rapid) text += " rapid";
  }
  return text;
}

TEST(PathRows, AreThoseOfPathsInConnectedPieces) {
  const Json joint = {{"start_tick", 0}, {"duration_ticks", 90}, {"taken_ticks", 90}};
  EXPECT_EQ(text_of(path_rows(run_with({joint, path_move(15, 25, false), path_move(40, 10, false)}))), "2-5");
  EXPECT_EQ(text_of(path_rows(run_with({path_move(0, 10, false), path_move(30, 20, false)}))), "0-1, 3-5");
}

TEST(PathRows, OfRapidsBeginWhereACutEnds) {
  EXPECT_EQ(text_of(path_rows(run_with({path_move(0, 30, true), path_move(30, 30, false), path_move(60, 20, true)}))),
            "0-2 rapid, 2-5, 5-8 rapid");
}

TEST(PathRows, InARoundedCornerTheLaterMoveCounts) {
  EXPECT_EQ(text_of(path_rows(run_with({path_move(0, 45, false), path_move(35, 20, true)}))), "0-3, 3-5 rapid");
}

TEST(PathRows, AMoveThatDidNotEndCountsAsPlanned) {
  Json move = path_move(20, 30, false);
  move["taken_ticks"] = nullptr;
  EXPECT_EQ(text_of(path_rows(run_with(Json::array({move})))), "2-5");
}

TEST(PathRows, WithoutAPathAreAllRows) {
  EXPECT_EQ(text_of(path_rows(run_with(Json::array()))), "0-9");
}

}  // namespace
}  // namespace armature::cosim
