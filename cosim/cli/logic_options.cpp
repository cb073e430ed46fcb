#include "cosim/cli/logic_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace armature::cosim {
namespace {

template <class Enum, std::size_t kCount>
void add_choice(CLI::App& command, const std::string& option, const std::array<std::string_view, kCount>& names,
                std::optional<Enum>& chosen, const std::string& help) {
  command
      .add_option_function<std::string>(
          option, [&names, &chosen](const std::string& name) { chosen = named<Enum>(names, name); }, help)
      ->check(CLI::IsMember(std::vector<std::string>(names.begin(), names.end())));
}

void refuse_old_option(CLI::App& command) {
  const std::string old = "--" + std::string{kOldLogicKey};
  command
      .add_option_function<std::string>(
          old,
          [old](const std::string& value) {
            const std::string_view meant = variant_of_old_key(value);
            const std::string name =
                meant.empty() ? fmt::format("{}", fmt::join(kVariantNames, " or --variant ")) : std::string{meant};
            throw CLI::ValidationError(old, "write --variant " + name);
          })
      ->group("");  // not in --help
}

}  // namespace

void add_logic_options(CLI::App& command, LogicChoice& chosen) {
  add_choice(command, "--variant", kVariantNames, chosen.variant,
             "Variant of the logic: 'counts', or 'paper' as Vo 2021 describes it (half periods, one decoder)");
  add_choice(command, "--engine", kEngineNames, chosen.engine,
             "Program that simulates the logic: 'rtl', the verilated SystemVerilog");
  refuse_old_option(command);
}

}  // namespace armature::cosim
