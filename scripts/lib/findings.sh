# shellcheck shell=bash
# Shared by findings/*.sh: a temporary folder, packages of a stated version, the verdict. Source it after `set -euo pipefail`.
# It sets `folder`, the temporary folder, which is removed at the end, and makes it the working folder.

source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 2
export OMP_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE=1
# What unpack brings is found first.
export PATH=$folder/root/usr/bin:$PATH
export LD_LIBRARY_PATH=$folder/root/usr/lib/$(uname -m)-linux-gnu${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export PYTHONPATH=$folder/root/usr/lib/python3/dist-packages

# skip REASON: this machine cannot have the package in that version. Exit status 77.
skip() {
  say "skipped: $*"
  exit 77
}

# judge COMMAND...: the command ends with status 0 if the behaviour is as stated, with 3 if it is another one. Anything else, such as
# an exception, judges nothing and is an error.
judge() {
  local status=0
  "$@" || status=$?
  case $status in
    0)
      say "still so"
      exit 0
      ;;
    3)
      say "changed: the numbers differ from those of the finding"
      exit 1
      ;;
  esac
  say "error: the finding was not judged, since '$*' ended with status $status"
  exit 2
}

# unpack PACKAGE=VERSION...: downloads the Debian packages and unpacks them below the temporary folder. Nothing is installed. With
# CONTINUA_FINDINGS_ANY_VERSION the version is the one that apt-get would install.
unpack() {
  command -v apt-get >/dev/null 2>&1 || skip "this machine has no apt-get"
  local wanted archive
  for wanted in "$@"; do
    [ -z "${CONTINUA_FINDINGS_ANY_VERSION:-}" ] || wanted=${wanted%%=*}
    # apt-get warns that it downloads as root into a folder that others cannot read; a mirror that fails once is asked again.
    apt-get -o Acquire::Retries=2 download "$wanted" >apt.log 2>&1 ||
      skip "apt-get finds no $wanted; 'apt-get update' may help: $(grep '^E:' apt.log | head -n 1)"
  done
  for archive in ./*.deb; do
    say "used: $(dpkg-deb --field "$archive" Package) $(dpkg-deb --field "$archive" Version)"
    dpkg-deb --extract "$archive" root
    rm "$archive"
  done
}

# need_installed PACKAGE VERSION: the package is installed, and its version begins with VERSION (any one will do with
# CONTINUA_FINDINGS_ANY_VERSION). For what depends on too many packages to be unpacked.
need_installed() {
  local version
  version=$(dpkg-query --show --showformat '${Version}' "$1" 2>/dev/null) || version=''
  [ -n "$version" ] || skip "$1 is not installed: apt-get install $1"
  if [ -z "${CONTINUA_FINDINGS_ANY_VERSION:-}" ]; then
    case $version in
      "$2"*) ;;
      *) skip "the finding is one of $1 $2, and $version is installed" ;;
    esac
  fi
  say "used: $1 $version"
}

# need_libraries PROGRAM: skips if a shared library is missing that the unpacked program needs.
need_libraries() {
  local missing
  missing=$(ldd "$(command -v "$1")" | awk '/not found/ { print $1 }' | tr '\n' ' ')
  [ -z "$missing" ] || skip "$1 does not find $missing; 'apt-get install $1' brings what it depends on"
}
