#!/bin/sh
# Downloads Debian's packages of GAlib and pagmo, with which bench/identification is compared, and unpacks them into a
# folder. They are not installed, because Debian's pagmo needs the headers of Boost 1.74, which exclude the headers of
# Boost 1.81 that PlacedPar needs.
# usage: tools/rivals.sh [FOLDER]
# The default folder is build/rivals. Configure again afterwards.
set -eu
top=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
folder=${1:-$top/build/rivals}
packages="libga2 libga-dev
          libpagmo8 libpagmo-dev libboost1.74-dev libboost-serialization1.74.0 libtbb12 libtbb-dev"

if ! command -v apt-get >/dev/null || ! command -v dpkg-deb >/dev/null; then
    echo "This is not a Debian system, so the packages cannot be unpacked. The benchmark also runs without these libraries." >&2
    exit 1
fi
mkdir -p "$folder/packages"
cd "$folder/packages"
# shellcheck disable=SC2086 # split into one word for each package
if ! apt-get download -qq $packages; then
    echo "apt could not download the packages; 'apt-get update' may help. PlacedPar is made for Debian 12 (bookworm)." >&2
    exit 1
fi
for package in *.deb; do
    dpkg-deb --extract "$package" "$folder"
done
echo "Unpacked into $folder"
