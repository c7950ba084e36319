#!/usr/bin/env bash
# Tries the README on a clean Debian 12: makes a root folder from the mirror that this machine's own
# apt uses, clones the committed state into it, runs the targets there and times them. Run as root.
# Usage: try_clean.sh [-w] [FOLDER [TARGET...]]; targets default to: demo test.
#   -w  copies the working tree as it is (without build/ and out/) in place of the last commit
# Needs mmdebstrap. An existing FOLDER/root is used again, its clone made anew.
set -euo pipefail
# In mounts of its own, which end with it.
if [[ -z ${SUNFLECK_OWN_MOUNTS:-} ]]; then
    SUNFLECK_OWN_MOUNTS=1 exec unshare --mount "$0" "$@"
fi
cd "$(dirname "$0")/.."
source_tree=$PWD

worktree=0
if [[ ${1:-} == -w ]]; then worktree=1 && shift; fi
folder=${1:-$(mktemp -d)}
if [[ $# -gt 0 ]]; then shift; fi
targets=("$@")
if [[ $# == 0 ]]; then targets=(demo test); fi
mkdir -p "$folder"
root=$folder/root

# The first address that the system's sources name for the main archive of this release.
mirror() {
    apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' 'Identifier: Packages' |
        awk '$2 == "bookworm" && $3 == "main" { print $1; exit }'
}

# What apt in the new root needs to reach the same mirror: names, certificates, proxies.
copy_network() {
    cp -L /etc/resolv.conf /etc/hosts "$root/etc/"
    mkdir -p "$root/usr/local/share/ca-certificates"
    cp -L /usr/local/share/ca-certificates/*.crt "$root/usr/local/share/ca-certificates/" \
        2>/dev/null || true
    apt-config dump | grep -E '^Acquire::(https?|Check|Retries)' >"$root/etc/apt/apt.conf.d/90host" ||
        true
    chroot "$root" update-ca-certificates >/dev/null 2>&1
}

# The environment of a fresh login, and the proxies of this one.
inside() {
    local kept=()
    for name in http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY; do
        if [[ -n ${!name:-} ]]; then kept+=("$name=${!name}"); fi
    done
    chroot "$root" env -i HOME=/srv LC_ALL=C.UTF-8 TERM=dumb "${kept[@]}" \
        PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "$@"
}

if [[ ! -d $root ]]; then
    mmdebstrap --variant=minbase --include=git,make,ca-certificates bookworm "$root" "$(mirror)"
fi
copy_network
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"
mount -t devpts -o ptmxmode=666 devpts "$root/dev/pts"
mount -t tmpfs tmpfs "$root/dev/shm"

clone=$root/srv/sunfleck
rm -rf "$clone"
if [[ $worktree == 1 ]]; then
    mkdir -p "$clone"
    tar -C "$source_tree" --exclude=./build --exclude=./out --exclude=./.git -cf - . |
        tar -C "$clone" -xf -
else
    git clone --quiet --no-hardlinks "$source_tree" "$clone"
fi

for target in "${targets[@]}"; do
    start=$(date +%s)
    inside make -C /srv/sunfleck "$target" </dev/null 2>&1 | tee "$folder/$target.log"
    echo "try_clean: make $target took $(($(date +%s) - start)) s" | tee -a "$folder/times.txt"
done
cat "$folder/times.txt"
