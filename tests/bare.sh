#!/bin/sh
# The README's commands on a bare machine: a Debian of which nothing is installed but
# what debootstrap calls minimal, and a fresh clone of the last commit.
#
#   sh tests/bare.sh build [RELEASE [whole]]     (bookworm; part of make check-slow)
#
# The commands run in the README's order, each from a clean environment, and before
# the packages are there plain make says what to type: as root, as a user without
# sudo, and without a network. Instead of `make check`, which takes ten minutes with
# what it installs, parts of it run; with "whole" it runs itself. Sources of packages
# are those of this machine. Without root, debootstrap or a network it says "skipped:
# why", and nothing counts as passed.
set -u
build=$(cd "${1:-build}" && pwd)
release=${2:-bookworm}
whole=${3:-}
facts=0
failed=0

skip() { echo "skipped: bare $release: $1" && exit 0; }
[ "$(id -u)" = 0 ] || skip "a chroot asks for root"
for program in debootstrap unshare chroot apt-get git; do
    command -v $program >/dev/null || skip "there is no $program"
done
unshare -m -p -n -f true 2>/dev/null || skip "unshare is not allowed"

debs=$build/bare/debs # kept, so that each package is fetched once
mkdir -p "$debs/partial"
root=$(mktemp -d "$build/bare/$release.XXXXXX")
chmod 755 "$root"
log=$root.log
trap 'rm -rf --one-file-system "$root" "$log"' EXIT
trap 'exit 130' INT TERM
# shellcheck disable=SC2016 # apt-get's own
site=$(apt-get indextargets --format '$(SITE)' 'Identifier: Packages' | head -n 1)
# shellcheck disable=SC2016
ours=$(apt-get indextargets --format '$(CODENAME)' 'Identifier: Packages' | head -n 1)
proxy=$(apt-config dump Acquire::http::Proxy --format '%v')
[ -z "$proxy" ] || export http_proxy="$proxy"
unshare -m debootstrap --variant=minbase --cache-dir="$debs" "$release" "$root" "$site" \
    >"$log" 2>&1 || skip "debootstrap: $(tail -n 1 "$log")"

# The sources of packages and how they are reached are this machine's.
(cd /etc/apt && tar cf - sources.list* apt.conf* auth.conf* keyrings 2>/dev/null) |
    tar xf - -C "$root/etc/apt"
rm -f "$root"/etc/apt/apt.conf.d/docker-* # packages are to be kept
[ "$release" = "$ours" ] || find "$root/etc/apt" -path '*sources*' -type f \
    -exec sed -i "s/\\b$ours\\b/$release/g" {} +
echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/bare" # it is thrown away
cp /etc/hosts /etc/resolv.conf "$root/etc"
git clone -q --bare --depth 1 "file://$PWD" "$root/winnow.git" || skip "this is no clone"

# inside COMMAND: in the chroot, from a clean environment, in the clone if there is one.
network=
kept=$debs
user=0
inside() {
    # shellcheck disable=SC2086,SC2016 # none or one; the inner shell's
    unshare -m -p $network -f sh -c 'mount -t proc proc "$1/proc" && mount --rbind /dev "$1/dev" &&
        { [ -z "$2" ] || mount --bind "$2" "$1/var/cache/apt/archives"; } &&
        exec env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root TERM=dumb chroot "$1" \
        setpriv --reuid="$3" --regid="$3" --clear-groups \
        timeout 1800 sh -c "{ cd /srv/winnow || cd /; } 2>/dev/null; $4"' \
        inside "$root" "$kept" "$user" "$1" >"$log" 2>&1 </dev/null
}

fact() { # NAME COMMAND
    began=$(date +%s)
    if inside "$2"; then
        facts=$((facts + 1)) && echo "    $1 ($(($(date +%s) - began)) s)"
    else
        echo "FAILED $1: exit code $?, and the last lines:" && tail -n 8 "$log"
        failed=$((failed + 1))
    fi
}

# What to type is one line, besides make's own and what was to be installed.
refused() { # NAME COMMAND
    if inside "$2" || [ "$(grep -c 'type: .*apt-get install.* libgsl-dev' "$log")" != 1 ] ||
        [ "$(grep -vc '^make\|^sh .ci/install\|^Installing' "$log")" != 1 ]; then
        echo "FAILED $1:" && head -n 8 "$log"
        failed=$((failed + 1))
    else
        facts=$((facts + 1)) && echo "    $1"
    fi
}

echo "bare $release:"
inside "apt-get update" || skip "apt-get update: $(tail -n 1 "$log")"
awk -f tests/commands.awk README.md >"$root/commands"
while read -r where _ command; do
    case $command in
    'sudo apt-get install '*)
        fact "$where: $command" "apt-get install -y ${command#*install }"
        fact "the clone" "git clone -q /winnow.git /srv/winnow"
        refused a_bare_make_says_what_to_type make
        network=-n kept=
        refused so_does_make_run_without_a_network "make run"
        network='' kept=$debs
        user=65534
        refused and_who_may_not_install "make run"
        user=0
        ;;
    'make check')
        if [ -n "$whole" ]; then fact "$where: $command" "$command"
        else fact "$where: parts of $command" "apt-get install -y check && make cli study tools text"; fi
        ;;
    *) fact "$where: $command" "${command#sudo }" ;;
    esac
done <"$root/commands"

echo "bare $release: $facts passed, $failed failed"
[ $failed -eq 0 ]
