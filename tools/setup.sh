# Sourced by tools/run, test, iss, python and bench: installs missing packages, configures and builds a preset.
# It prints nothing when there is nothing to do. When a step fails, it prints the log.

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"

say() { printf '%s\n' "$*" >&2; }

# quietly LOG COMMAND...: runs a command with its output in LOG; prints the log only if the command fails.
quietly() {
  local log="$1"
  shift
  if ! "$@" >"$log" 2>&1; then
    cat "$log" >&2
    say "failed: $*"
    return 1
  fi
}

# install_packages [PACKAGE...]: installs the packages of packages.txt, and PACKAGE...
install_packages() {
  local wanted missing=() package sudo=()
  mapfile -t wanted < <(grep -v '^#' "$root/tools/packages.txt")
  for package in "${wanted[@]}" "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  ((${#missing[@]} == 0)) && return
  say "installing ${missing[*]}"
  ((EUID == 0)) || sudo=(sudo)
  "${sudo[@]}" apt-get update -qq
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# build_preset PRESET [TARGET...]
build_preset() {
  local preset="$1" dir="$root/build/$1"
  shift
  mkdir -p "$dir"
  # After a change of the list of RTL sources or of the preset, configure before ninja reads the old build files.
  if [[ ! -f "$dir/build.ninja" || "$root/rtl/rtl.f" -nt "$dir/build.ninja" ||
    "$root/CMakePresets.json" -nt "$dir/build.ninja" ]]; then
    say "configuring $preset"
    (cd "$root" && quietly "$dir/configure.log" cmake --preset "$preset")
  fi
  if [[ -t 2 ]]; then
    (cd "$root" && cmake --build "$dir" ${1:+--target "$@"} >&2)
  else
    say "building $preset"
    (cd "$root" && quietly "$dir/build.log" cmake --build "$dir" ${1:+--target "$@"})
  fi
}
