#!/usr/bin/env bash
# Proves that ./demo and ./check work on a fresh Debian 12 with nothing but git: in a chroot made by debootstrap, as root,
# as a user with sudo, and as a user without. What is committed is what is tried. Takes root, debootstrap and a
# network; takes minutes and some gigabytes, so it is no part of ctest.
#
# usage: tests/fresh_machine.sh FOLDER    FOLDER is made; FOLDER/base is kept for the next time
# MIRROR names another Debian mirror.
set -euo pipefail

folder=${1:?usage: tests/fresh_machine.sh FOLDER}
mirror=${MIRROR:-http://deb.debian.org/debian}
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
[ "$(id -u)" = 0 ] || { echo "chroot and debootstrap take root" >&2; exit 1; }
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
machine=""

say() { printf '\n== %s %s\n' "$(date +%T)" "$*"; }

remove_machine() {
    [ -n "$machine" ] || return 0
    umount "$machine/proc" "$machine/dev/pts"
    rm -rf --one-file-system "$machine"
    machine=""
}
trap remove_machine EXIT

# Debian with git, and the way to the mirror that this machine uses.
make_base() {
    rm -rf --one-file-system "$folder/base"
    debootstrap --variant=minbase --include=git,ca-certificates bookworm "$folder/base.part" "$mirror"
    cp /etc/resolv.conf /etc/hosts "$folder/base.part/etc/"
    apt-config dump | grep -i '::proxy' >"$folder/base.part/etc/apt/apt.conf.d/90proxy" || true
    mv "$folder/base.part" "$folder/base"
}

# machine_for USER: a fresh machine with the user, whose home is /srv, and a clone in a folder whose name has a blank.
machine_for() {
    machine=$folder/$1
    cp -a "$folder/base" "$machine"
    mount -t proc proc "$machine/proc"
    mount --bind /dev/pts "$machine/dev/pts" # what a terminal shows is tested on pseudoterminals
    [ "$1" = root ] || chroot "$machine" useradd --home-dir /srv "$1"
    git clone --quiet --no-hardlinks "$top" "$machine/srv/placed par"
    chroot "$machine" chown -R "$1" /srv
}

# as USER COMMAND...: runs it on the machine, from a folder that is not the project's.
as() {
    local user=$1
    shift
    chroot --userspec="$user" "$machine" env -i HOME=/srv PATH=/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb \
        sh -c 'cd / && exec "$@"' sh "$@"
}

[ -d "$folder/base" ] || make_base

say "root: ./demo, then ./check"
machine_for root
as root "/srv/placed par/demo"
as root "/srv/placed par/check"
remove_machine

say "a user without sudo: refused with a message"
machine_for without
if as without "/srv/placed par/demo" >"$folder/refusal" 2>&1; then
    echo "./demo should have failed" >&2
    exit 1
fi
cat "$folder/refusal"
grep -q 'needs root or sudo' "$folder/refusal"
remove_machine

say "a user with sudo: ./check, then ./demo without network and rights"
machine_for with
chroot "$machine" sh -c 'apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -qq -y sudo >/dev/null'
echo 'with ALL=(ALL) NOPASSWD: ALL' >"$machine/etc/sudoers.d/with"
as with "/srv/placed par/check"
rm "$machine/etc/sudoers.d/with"
unshare --net -- bash -c "$(declare -f as); machine='$machine'; as with '/srv/placed par/demo'"
remove_machine

say "everything worked"
