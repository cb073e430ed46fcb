#include "cosim/cli/options/logic_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "controller/base/words.hpp"
#include "cosim/cli/options/word_option.hpp"

namespace armature::cosim {
namespace {

void refuse_old_option(CLI::App& command) {
  const std::string old = "--" + std::string{kOldLogicKey};
  command
      .add_option_function<std::string>(
          old,
          [old](const std::string& value) {
            const std::string_view meant = variant_of_old_key(value);
            const std::string name =
                meant.empty() ? fmt::format("{}", fmt::join(kWordsOf<Variant>, " or --variant ")) : std::string{meant};
            throw CLI::ValidationError(old, "write --variant " + name);
          })
      ->group("");  // not in --help
}

}  // namespace

void add_logic_options(CLI::App& command, LogicChoice& chosen) {
  add_word_option(command, "--variant", chosen.variant,
                  "Variant of the logic: 'counts', or 'paper' as Vo 2021 describes it (half periods, one decoder)");
  add_word_option(command, "--engine", chosen.engine, without_markdown(kEngineHelp));
  refuse_old_option(command);
}

void add_engines_option(CLI::App& command, std::vector<Engine>& chosen) {
  constexpr const char* kBoth = "both";
  std::vector<std::string> words(kWordsOf<Engine>.begin(), kWordsOf<Engine>.end());
  words.emplace_back(kBoth);
  command
      .add_option_function<std::string>(
          "--engine",
          [&chosen](const std::string& word) {
            chosen =
                word == kBoth ? std::vector{Engine::kRtl, Engine::kModel} : std::vector{*enumerator_of<Engine>(word)};
          },
          without_markdown(kEngineHelp) + " 'both': the RTL, then the model (default: as the scenario says)")
      ->check(CLI::IsMember(words));
}

}  // namespace armature::cosim
