#!/usr/bin/env bash
# Installs the missing ones of the Debian packages that tools/packages.txt lists.
# Usage: setup.sh GROUP... (build, test, browser, mpi, nightly). As root it installs; at a terminal it asks, then
# calls sudo; otherwise it prints the command and fails.
set -euo pipefail
list=$(dirname "$0")/packages.txt

if ! command -v dpkg-query >/dev/null; then
    echo "setup: no Debian here; what is needed is listed in tools/packages.txt" >&2
    exit 0
fi

# What is installed, by its own names and by those that it provides: Node.js of its makers brings npm.
installed=" $(dpkg-query -W -f '${db:Status-Status} ${Package}, ${Provides}\n' |
    sed -n 's/^installed //p' | sed 's/([^)]*)//g' | tr -s ', \n' ' ') "

missing=()
for group in "$@"; do
    known=0
    while read -r of_group package _; do
        if [[ $of_group != "$group" ]]; then continue; fi
        known=1
        if [[ $installed != *" $package "* ]]; then
            missing+=("$package")
        fi
    done <"$list"
    if [[ $known == 0 ]]; then
        echo "setup: no group $group in tools/packages.txt" >&2
        exit 2
    fi
done
if [[ ${#missing[@]} == 0 ]]; then exit 0; fi

install="apt-get install -y --no-install-recommends ${missing[*]}"
if [[ $(id -u) == 0 ]]; then
    echo "setup: apt-get update && $install"
    export DEBIAN_FRONTEND=noninteractive
    apt-get update
    $install
elif [[ -t 0 && -t 1 ]]; then
    echo "setup: sudo apt-get update && sudo $install"
    read -r -p "Run this now? [y/N] " answer
    if [[ $answer != [yY]* ]]; then exit 1; fi
    sudo apt-get update
    sudo DEBIAN_FRONTEND=noninteractive $install
else
    echo "setup: packages are missing; run as root: apt-get update && $install" >&2
    exit 1
fi
