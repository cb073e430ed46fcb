#include "cosim/cli/shell_completion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "cosim/cli/value_kinds.hpp"
#include "cosim/text/shell_text.hpp"

namespace armature::cosim {
namespace {

// The parts of the script that do not depend on the commands. `_armature_takes COMMAND WORD` sets `kind` and `most` to
// the kind and the largest number of the values of an option; WORD is a number for an argument: 1 for the first.
constexpr const char* kBashHead = R"(# Completion for bash, written by 'armature completion bash'.

)";
constexpr const char* kBashFunctions = R"bash(
# Adds what a value of this kind can be, to COMPREPLY.
_armature_values() {
  local names=
  case $1 in
    FILE) compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -f -- "$word") ;;
    DIR) compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -d -- "$word") ;;
    SCENARIO | ROBOT)
      compopt -o filenames 2>/dev/null
      names=scenarios
      [[ $1 == ROBOT ]] && names=robots
      names=$("$program" "${path[@]}" list --names "$names" 2>/dev/null)
      mapfile -t COMPREPLY < <({ compgen -W "$names" -- "$word"; compgen -f -- "$word"; } | sort -u)
      ;;
    =*) mapfile -t COMPREPLY < <(compgen -W "${1#=}" -- "$word") ;;
  esac
}

_armature() {
  local program=$1 word=${COMP_WORDS[COMP_CWORD]} command= left=0 argument=0 of_option= kind= most=0 i one
  local path=()
  [[ $word == = ]] && word=
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; i++)); do
    one=${COMP_WORDS[i]}
    [[ $one == = ]] && continue
    if [[ $one == -* ]]; then
      kind= most=0
      _armature_takes "$command" "$one"
      left=$most of_option=$kind
      [[ $one == --path ]] && path+=(--path)
    elif ((left > 0)); then
      left=$((left - 1))
      ((${#path[@]} % 2 == 1)) && path+=("${one/#\~/$HOME}")
    elif [[ -z $command ]]; then
      command=$one
    else
      argument=$((argument + 1))
    fi
  done
  ((${#path[@]} % 2 == 1)) && unset 'path[-1]'
  if [[ $word == -* ]]; then
    _armature_values "=$(_armature_options "$command")"
  elif ((left > 0)); then
    _armature_values "$of_option"
  elif [[ -z $command ]]; then
    _armature_values "=$_armature_commands"
  else
    kind= most=0
    _armature_takes "$command" $((argument + 1))
    _armature_values "$kind"
  fi
}

complete -F _armature armature
)bash";

constexpr int kNoLimit = 1'000;  // of values: more than a command line has

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

// The kind as _armature_values takes it: `=counts paper` for words.
std::string kind_word(const OptionRow& option) {
  return shell_word(option.choices.empty() ? option.kind : "=" + joined(option.choices));
}

// `"run "--jobs|"run "-j) kind=INT most=1 ;;`
std::string takes_case(const std::string& command, const OptionRow& option) {
  std::string pattern;
  for (const std::string& name : option.names)
    pattern += fmt::format("{}\"{} {}\"", pattern.empty() ? "" : " | ", command, name);
  return fmt::format("    {}) kind={} most={} ;;\n", pattern, kind_word(option),
                     std::min(option.most_values, kNoLimit));
}

// The arguments, by their number. The last one has all further numbers if it can be repeated.
std::string argument_cases(const CommandRow& command) {
  std::string text;
  int number = 0;
  for (const OptionRow& option : command.options) {
    if (!option.positional) continue;
    const std::string any = option.most_values > 1 ? "*" : std::to_string(++number);
    text += fmt::format("    \"{} \"{}) kind={} ;;\n", command.name, any == "*" ? "[0-9]*" : any, kind_word(option));
  }
  return text;
}

std::string option_names(const CommandRow& command) {
  std::vector<std::string> names;
  for (const OptionRow& option : command.options) {
    if (!option.positional) std::ranges::copy(option.names, std::back_inserter(names));
  }
  return joined(names);
}

}  // namespace

std::string bash_completion(const CommandRow& program, const std::vector<CommandRow>& commands) {
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const CommandRow& command : commands) names.push_back(command.name);
  std::string script = kBashHead;
  fmt::format_to(std::back_inserter(script), "_armature_commands='{}'\n\n", joined(names));
  const std::string common = option_names(program);
  script += "_armature_options() {\n  case $1 in\n";
  for (const CommandRow& command : commands) {
    fmt::format_to(std::back_inserter(script), "    {}) echo '{} {} --help' ;;\n", command.name, option_names(command),
                   common);
  }
  fmt::format_to(std::back_inserter(script), "    *) echo '{} --help' ;;\n  esac\n}}\n\n", common);
  script += "_armature_takes() {\n  case \"$1 $2\" in\n";
  for (const OptionRow& option : program.options) {
    if (option.most_values > 0)
      fmt::format_to(std::back_inserter(script), "    *\" {}\") kind={} most=1 ;;\n", option.names.front(),
                     kind_word(option));
  }
  for (const CommandRow& command : commands) {
    for (const OptionRow& option : command.options) {
      if (!option.positional && option.most_values > 0) script += takes_case(command.name, option);
    }
    script += argument_cases(command);
  }
  return script + "  esac\n}\n" + kBashFunctions;
}

}  // namespace armature::cosim
