#include "cosim/campaign/campaign_case.hpp"

#include <fmt/format.h>

#include "cosim/text/number_text.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

constexpr const char* kProgramFile = "program.jbi";

}  // namespace

std::string scenario_text(const CampaignCase& drawn) {
  std::string text = fmt::format("description = \"{}\"\nrobot = \"{}\"\nduration_s = {}\nseed = {}\n",
                                 drawn.description, drawn.robot, number_text(drawn.duration_s), drawn.seed);
  if (drawn.has_program()) text += fmt::format("program = \"{}\"\n", kProgramFile);
  text += drawn.keys;
  if (!drawn.has_program()) {
    for (const std::string& move : drawn.steps) text += "\n[[move]]\n" + move;
  }
  for (const std::string& fault : drawn.faults) text += "\n[[fault]]\n" + fault;
  return text;
}

std::string program_text(const CampaignCase& drawn) {
  std::string text = fmt::format("/JOB\n//NAME PROGRAM\n//POS\n///NPOS {},0,0,0,0,0\n///POSTYPE ANGLE\n///ANGLE\n",
                                 drawn.places.size());
  for (std::size_t i = 0; i < drawn.places.size(); ++i) text += fmt::format("C{}={}\n", i, drawn.places[i]);
  text += "//INST\nNOP\n";
  for (const std::string& line : drawn.steps) text += line + '\n';
  return text + "END\n";
}

void write_case(const CampaignCase& drawn, const std::filesystem::path& folder) {
  replace_text_file(folder / kScenarioFile, scenario_text(drawn));
  if (drawn.has_program()) replace_text_file(folder / kProgramFile, program_text(drawn));
}

Scenario load_case(const CampaignCase& drawn, const std::filesystem::path& folder, const LoadOptions& options) {
  write_case(drawn, folder);
  return load_scenario(folder, options);
}

}  // namespace armature::cosim
