# shellcheck shell=bash
# Shared by the scripts in scripts/ and .ci/: where things are, the environment of a run, packages, the build.
# Source it after `set -euo pipefail`.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build_root=${CONTINUA_BUILD_ROOT:-$root/build}
python=/usr/bin/python3 # Debian's, which has the packages; another one may come first in PATH
export root build_root python

# One thread a rank; more ranks than cores and root are allowed, since containers and small machines have both.
set_run_environment() {
  export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1
  # What Open MPI 4 reads, and what Open MPI 5 does.
  export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none
  export PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe PRTE_MCA_hwloc_default_binding_policy=none
  if [ "$(id -u)" -eq 0 ]; then
    export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  fi
}

say() { printf '%s\n' "$*"; }

fail() {
  printf 'error: %s\n' "$*" >&2
  exit 1
}

# The release whose packages are taken: bookworm or trixie, or for another one trixie with a note.
debian_release() {
  local file=${CONTINUA_OS_RELEASE:-/etc/os-release} name='' codename=''
  if [ -r "$file" ]; then
    # shellcheck disable=SC1090
    name=$(. "$file" && printf '%s' "${PRETTY_NAME:-}")
    # shellcheck disable=SC1090
    codename=$(. "$file" && [ "${ID:-}" = debian ] && printf '%s' "${VERSION_CODENAME:-}") || codename=''
  fi
  case $codename in
    bookworm | trixie) say "$codename" ;;
    *)
      say "note: this is ${name:-no known release}; the packages are those of Debian 13 (trixie)" >&2
      say trixie
      ;;
  esac
}

# The number in the names of packages for that release: debian_number bookworm|trixie.
debian_number() {
  case $1 in
    bookworm) say 12 ;;
    trixie) say 13 ;;
    *) fail "unknown release $1 (there are bookworm and trixie)" ;;
  esac
}

# Puts what scripts/build/report-assets has brought into the build folder of a clean root, which has no npm: put_report_assets ROOT.
put_report_assets() {
  mkdir -p "$1/continua/build"
  rm -rf "$1/continua/build/report-assets"
  cp -R "$build_root/report-assets" "$1/continua/build"
}

# The packages of the groups named, one a line: what [GROUP] lists and what [GROUP RELEASE] adds.
list_packages() {
  local release group
  release=$(debian_release)
  for group in "$@"; do
    sed -e 's/#.*//' -e 's/[[:space:]]*$//' "$root/scripts/packages.txt" |
      awk -v every="[$group]" -v this="[$group $release]" \
        '/^\[/ { inside = ($0 == every || $0 == this); next } inside && NF { print $1 }'
  done | sort -u
}

# Installs what is missing of the groups named. Calls apt-get only when something is missing.
require_packages() {
  local missing=() package
  if ! command -v dpkg-query >/dev/null 2>&1; then
    say "This is not Debian: taking it that the counterparts of these are there: $(list_packages "$@" | tr '\n' ' ')"
    return 0
  fi
  while read -r package; do
    if [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
      missing+=("$package")
    fi
  done < <(list_packages "$@")
  [ ${#missing[@]} -gt 0 ] || return 0

  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null 2>&1 ||
      fail "these packages are missing and neither root nor sudo is at hand to install them: ${missing[*]}"
    as_root=(sudo)
  fi
  say "Installing ${#missing[@]} packages: ${missing[*]}"
  "${as_root[@]}" apt-get update -qq </dev/null
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" </dev/null
}

# Compile jobs: a deal.II file takes up to 2 GB, so memory counts as much as cores.
n_jobs() {
  local cores memory
  cores=$(env -u OMP_NUM_THREADS nproc) # which takes the threads of a rank for the cores, else
  memory=$(awk '/MemAvailable/ { print int($2 / 2000000) }' /proc/meminfo 2>/dev/null || echo "$cores")
  [ "${memory:-0}" -ge 1 ] || memory=1
  if [ "$memory" -lt "$cores" ]; then echo "$memory"; else echo "$cores"; fi
}

# Minutes of processor time that compiling the Release program takes, as scripts/measure/building measured them.
building_minutes() {
  awk -F , '$1 == "processor time" { printf "%.0f\n", $2 / 60 }' "$root/scripts/measure/building.csv"
}

# Sets `processor` to the processor seconds of all that this shell has started and waited for. (A subshell would have its own.)
take_processor_seconds() {
  local file
  file=$(mktemp)
  times >"$file"
  processor=$(awk 'NR == 2 { for (i = 1; i <= 2; ++i) { split($i, t, /[ms]/); sum += 60 * t[1] + t[2] } printf "%d\n", sum }' "$file")
  rm -f "$file"
}

# Says what is done now, and how long what came before it took. Without a text: only the latter. What a phase took is kept in
# build/phases.csv, for scripts/measure/suite.
announce() {
  local processor
  take_processor_seconds
  if [ -n "${announced:-}" ]; then
    say "-- $announced: done in $((SECONDS - announced_at)) s, $((processor - announced_processor)) s of processor time"
    mkdir -p "$build_root"
    say "\"$announced\",$((SECONDS - announced_at)),$((processor - announced_processor))" >>"$build_root/phases.csv"
  fi
  announced=${1:-}
  announced_at=$SECONDS
  announced_processor=$processor
  [ -z "$announced" ] || say "-- $announced"
}

# configure_build release|debug|sanitize [CMAKE OPTION...]: build/NAME, which is kept; only the first call picks a generator, ninja
# where it is installed.
configure_build() {
  local name=$1 directory type
  shift
  directory=$build_root/$name
  case $name in
    release) type=Release ;;
    debug) type=Debug ;;
    sanitize) type=Release ;; # as it is used; -O1 comes after the type's own options
    *) fail "no build named $name" ;;
  esac
  local generator=()
  # CMake refuses a folder that was configured for another place, as after moving the checkout.
  if [ -f "$directory/CMakeCache.txt" ] &&
    ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$directory/CMakeCache.txt"; then
    say "$directory was configured for another checkout: starting it afresh"
    rm -rf "$directory"
  fi
  if [ ! -f "$directory/CMakeCache.txt" ] && command -v ninja >/dev/null 2>&1; then
    generator=(-G Ninja)
  fi
  mkdir -p "$directory"
  if ! cmake -S "$root" -B "$directory" "${generator[@]}" -D CMAKE_BUILD_TYPE="$type" "$@" \
    >"$directory/configure.log" 2>&1; then
    cat "$directory/configure.log" >&2
    fail "configuring $directory failed"
  fi
}

# build_targets release|debug|sanitize TARGET...
build_targets() {
  local name=$1
  shift
  say "Building ${*} in $build_root/$name with $(n_jobs) jobs; one step is several files and takes up to a minute"
  NINJA_STATUS="$name [%f of %t, %e s] " cmake --build "$build_root/$name" --target "$@" --parallel "$(n_jobs)" </dev/null
}

# The Release program, built when it is out of date.
build_program() {
  configure_build release
  build_targets release continua
}

# What the tests need: the Release program, with the tests of its wide instructions, and beside it program and unit tests in Debug. Both
# compile at a time where there is memory for it, the Release program first: then no core waits for the last file of either.
build_tests() {
  configure_build release -D CONTINUA_TESTS=ON
  # Information for a debugger would double the time, and wide instructions are tested in Release.
  configure_build debug -D CONTINUA_DEBUG_SYMBOLS=OFF -D CONTINUA_INSTRUCTIONS=baseline \
    -D CONTINUA_TESTS=ON -D CONTINUA_RELEASE_PROGRAM="$build_root/release/continua"
  local jobs memory beside=''
  jobs=$(n_jobs)
  memory=$(awk '/MemAvailable/ { print int($2 / 2000000) }' /proc/meminfo 2>/dev/null || echo 0)
  if [ "$memory" -ge $((2 * jobs)) ]; then
    nice -n 5 bash -c 'set -euo pipefail; source "$1"; build_targets debug continua unit_tests' bash "$root/scripts/lib/common.sh" &
    beside=$!
  fi
  if ! build_targets release continua unit_tests_instructions; then
    [ -z "$beside" ] || kill "$beside" 2>/dev/null || true
    fail "the Release program cannot be built"
  fi
  if [ -z "$beside" ]; then
    build_targets debug continua unit_tests
  else
    wait "$beside" || fail "program and unit tests in Debug cannot be built"
  fi
}
