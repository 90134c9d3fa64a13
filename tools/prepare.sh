# Sourced by ./demo and ./check: installs what is missing, configures and builds. Leaves the shell in the top folder.
# PLACEDPAR_PRESET names the CMake preset (release), target what to build (everything).
set -eu
CDPATH='' cd -- "$(dirname -- "$0")"

preset=${PLACEDPAR_PRESET:-release}
tools/install_packages
cmake --preset "$preset" >/dev/null
cmake --build --preset "$preset" ${target:+--target "$target"}
