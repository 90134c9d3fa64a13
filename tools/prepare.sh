# ./demo and ./check source this script. It installs missing packages, configures, and builds. Afterwards the shell is
# in the top folder.
# PLACEDPAR_PRESET: the CMake preset; default: release. target: the target to build; default: all targets.
set -eu
CDPATH='' cd -- "$(dirname -- "$0")"

preset=${PLACEDPAR_PRESET:-release}
tools/install_packages
cmake --preset "$preset" >/dev/null
cmake --build --preset "$preset" ${target:+--target "$target"}
