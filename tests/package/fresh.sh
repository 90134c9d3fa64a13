#!/usr/bin/env bash
# Proves that the Debian packages install on a fresh Debian 12 with what they depend on and nothing else, that program, manual
# page, unit and a project with the rooms work there, and that nothing is left when they are purged.
#
# usage: tests/package/fresh.sh FOLDER PACKAGES    FOLDER/base is kept for the next time; PACKAGES is where the .deb files are
# MIRROR names another Debian mirror.
set -euo pipefail

folder=${1:?usage: tests/package/fresh.sh FOLDER PACKAGES}
packages=${2:?usage: tests/package/fresh.sh FOLDER PACKAGES}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
[ "$(id -u)" = 0 ] || { echo "chroot and debootstrap take root" >&2; exit 1; }
mkdir -p "$folder"
root=$folder/machine

if ! [ -d "$folder/base" ]; then
    rm -rf --one-file-system "$folder/base.part"
    debootstrap --variant=minbase bookworm "$folder/base.part" "${MIRROR:-http://deb.debian.org/debian}"
    cp /etc/resolv.conf /etc/hosts "$folder/base.part/etc/"
    apt-config dump | grep -i '::proxy' >"$folder/base.part/etc/apt/apt.conf.d/90proxy" || true
    mv "$folder/base.part" "$folder/base"
fi
rm -rf --one-file-system "$root"
cp -a "$folder/base" "$root"
mount -t proc proc "$root/proc"
trap 'umount "$root/proc" && rm -rf --one-file-system "$root"' EXIT
cp "$packages"/*placedpar*.deb "$root/srv/"
cp -r "$here/../consumer/small" "$root/srv/"

on() { chroot "$root" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 "$@"; }

on apt-get update -qq
on sh -c 'apt-get install -qq -y --no-install-recommends /srv/placedpar_*.deb >/dev/null'
on placedpar replay table-e1 >/dev/null
on placedpar run /usr/share/doc/placedpar/examples/thesis/figure-e2/figure-e2.cfs >/dev/null
on sh -c 'program=$(sed -n "s/^ExecStart=\"\([^\"]*\)\".*/\1/p" /usr/lib/systemd/system/placedpar-monitor.service) && "$program" --version'
on sh -c 'test -s /usr/share/doc/placedpar/copyright && test -s /usr/share/man/man1/placedpar.1'

on sh -c 'apt-get install -qq -y --no-install-recommends g++ cmake ninja-build /srv/libplacedpar-dev_*.deb >/dev/null'
on cmake -G Ninja -S /srv/small -B /srv/build >/dev/null
on cmake --build /srv/build >/dev/null
for program in plain_20 lto_23 address_20 address_23; do
    on /srv/build/$program
done

on apt-get purge -qq -y placedpar libplacedpar-dev >/dev/null
left=$(find "$root/usr" "$root/etc" "$root/var/lib" -iname '*placedpar*' -not -path '*/dpkg/*')
[ -z "$left" ] || { printf 'left behind:\n%s\n' "$left" >&2; exit 1; }
echo "installed, tried and purged on a fresh Debian $(cat "$root/etc/debian_version")"
