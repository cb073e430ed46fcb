#include "cosim/scenario/files/pendant_file.hpp"

#include <cstddef>
#include <filesystem>
#include <string>

#include "cosim/text/printable.hpp"
#include "cosim/text/text_file.hpp"

namespace armature::cosim {
namespace {

namespace fs = std::filesystem;

}  // namespace

void load_pendant_programs(Scenario& scenario, std::vector<Problem>& all) {
  if (!scenario.pendant) return;
  for (std::size_t i = 0; i < scenario.pendant->steps.size(); ++i) {
    PendantStepSpec& step = scenario.pendant->steps[i];
    if (step.act != PendantAct::kDownload) continue;
    const fs::path file = (fs::path{scenario.file}.parent_path() / step.file).lexically_normal();
    const auto problem = [&](const std::string& message) {
      all.push_back(Problem{scenario.file, Origin{step.line, 1, {}}, "pendant.step[" + std::to_string(i) + "].file",
                            message + ": " + printable(file.string())});
    };
    if (!is_file(file)) {
      problem("no such file");
      continue;
    }
    try {
      step.text = read_ascii_file(file, kMaxSentBytes);
      if (step.text.empty()) problem("the file is empty");
      scenario.sources.push_back(input_file(file, step.text));
    } catch (const InputError& error) {
      all.insert(all.end(), error.problems().begin(), error.problems().end());
    }
  }
}

}  // namespace armature::cosim
