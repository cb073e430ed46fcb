# Sourced by tools/run and tools/test: installs what is missing, then configures and builds a preset.
# Quiet when there is nothing to do; the logs are shown when a step fails.

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"

say() { printf '%s\n' "$*" >&2; }

# Runs a command with its output in a log; shows the log only when the command fails.
quietly() {
  local log="$1"
  shift
  if ! "$@" >"$log" 2>&1; then
    cat "$log" >&2
    say "failed: $*"
    return 1
  fi
}

install_packages() {
  local wanted missing=() package sudo=()
  mapfile -t wanted < <(grep -v '^#' "$root/tools/packages.txt")
  for package in "${wanted[@]}"; do
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
  # A new list of RTL sources must be configured before ninja looks at the old one.
  if [[ ! -f "$dir/build.ninja" || "$root/rtl/rtl.f" -nt "$dir/build.ninja" ]]; then
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
