#include "cosim/cli/options/shell_completion.hpp"

#include <cstddef>

namespace armature::cosim {
namespace {

constexpr std::string_view kBashScript = R"bash(# Completion for bash, written by 'armature completion bash'.

_armature() {
  local word=${COMP_WORDS[COMP_CWORD]} paths=none
  [[ $word == = ]] && word=
  COMPREPLY=()
  {
    read -r paths
    mapfile -t COMPREPLY
  } < <("$1" completion bash -- "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
  [[ $paths == none ]] && return
  compopt -o filenames 2>/dev/null
  local option=-f
  [[ $paths == folders ]] && option=-d
  mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen "$option" -- "$word")
}

complete -F _armature armature
)bash";

// A file of $fpath is the body of the function of its name; other files define the function.
constexpr std::string_view kZshScript = R"zsh(#compdef armature
# Completion for zsh, written by 'armature completion zsh'.

_armature() {
  local -a offered
  offered=("${(@f)$("${(Q)words[1]}" completion zsh -- "${(@Q)words[2,CURRENT]}" 2>/dev/null)}")
  local paths=$offered[1]
  shift offered
  (( $#offered )) && _describe -V 'armature' offered
  case $paths in
    files) _files ;;
    folders) _files -/ ;;
  esac
}

if [[ $funcstack[1] == _armature ]]; then
  _armature "$@"
else
  compdef _armature armature
fi
)zsh";

constexpr std::string_view kFishScript = R"fish(# Completion for fish, written by 'armature completion fish'.

function __armature_offered
    set -l words (commandline -opc)
    set -l word (commandline -ct)
    set -l offered ($words[1] completion fish -- $words[2..-1] "$word" 2>/dev/null)
    set -q offered[2]; and printf '%s\n' $offered[2..-1]
    switch "$offered[1]"
        case files
            __fish_complete_path "$word"
        case folders
            __fish_complete_directories "$word"
    end
end

complete -c armature -f -k -a '(__armature_offered)'
)fish";

std::string bash_line(const OfferedWord& word) {
  return word.word;
}

// `word:description`, as _describe reads it.
std::string zsh_line(const OfferedWord& word) {
  std::string line;
  for (const char c : word.word) {
    if (c == ':' || c == '\\') line += '\\';
    line += c;
  }
  return word.description.empty() ? line : line + ":" + word.description;
}

std::string fish_line(const OfferedWord& word) {
  return word.description.empty() ? word.word : word.word + "\t" + word.description;
}

}  // namespace

const std::array<ShellKind, 3>& shell_kinds() {
  static constexpr std::array<ShellKind, 3> kKinds{
      {{"bash", kBashScript, bash_line}, {"zsh", kZshScript, zsh_line}, {"fish", kFishScript, fish_line}}};
  return kKinds;
}

std::string answer_text(const ShellKind& shell, const Offer& offer) {
  static constexpr std::string_view kPaths[] = {"none", "files", "folders"};
  std::string text{kPaths[static_cast<std::size_t>(offer.paths)]};
  for (const OfferedWord& word : offer.words) text += "\n" + shell.line(word);
  return text + "\n";
}

}  // namespace armature::cosim
