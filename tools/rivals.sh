#!/bin/sh
# Fetches the libraries that bench/identification is compared with, GAlib and pagmo, as Debian 12 has them, and unpacks
# them into a folder. Installs nothing: Debian's pagmo needs the headers of Boost 1.74, which exclude our 1.81's.
# usage: tools/rivals.sh [FOLDER]    build/rivals; then configure again
set -eu
top=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
folder=${1:-$top/build/rivals}
packages="libga2 libga-dev
          libpagmo8 libpagmo-dev libboost1.74-dev libboost-serialization1.74.0 libtbb12 libtbb-dev"

if ! command -v apt-get >/dev/null || ! command -v dpkg-deb >/dev/null; then
    echo "This is not a Debian system. The benchmark runs without rivals too." >&2
    exit 1
fi
mkdir -p "$folder/packages"
cd "$folder/packages"
# shellcheck disable=SC2086 # one word for each package
if ! apt-get download -qq $packages; then
    echo "apt could not fetch them; 'apt-get update' may help. PlacedPar is made for Debian 12 (bookworm)." >&2
    exit 1
fi
for package in *.deb; do
    dpkg-deb --extract "$package" "$folder"
done
echo "Unpacked into $folder"
