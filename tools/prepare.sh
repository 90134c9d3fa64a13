# Sourced by ./demo and ./check: installs what is missing, then configures and builds the release preset.
# Leaves the shell in the top folder.
set -eu
cd "$(dirname "$0")"

missing=""
for package in $(sed 's/#.*//' packages.txt | awk 'NF {print $1}'); do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing="$missing $package"
done

if [ -n "$missing" ]; then
    if [ "$(id -u)" = 0 ]; then
        as_root=env
    elif command -v sudo >/dev/null; then
        as_root="sudo env"
    else
        echo "These packages are missing, and installing them takes root or sudo:$missing" >&2
        exit 1
    fi
    if dpkg-query -W -f '${Status}' libboost1.74-dev 2>/dev/null | grep -q 'ok installed'; then
        echo "Note: Debian's headers of Boost 1.74 and 1.81 exclude each other; apt replaces 1.74 by 1.81."
    fi
    echo "Installing:$missing"
    $as_root apt-get update -qq
    # shellcheck disable=SC2086 # one word for each package
    $as_root DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
fi

cmake --preset "${PRESET:=release}" ${CMAKE_ARGUMENTS:-} >/dev/null
cmake --build --preset "$PRESET"
