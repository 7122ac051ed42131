#!/usr/bin/env bash
# Prepares a Debian 12 machine: the packages of apt-packages.txt, a Python environment in .venv for
# the HTML report, and real meshes in data/meshes/cgal. As root or with sudo; asks nothing; may be
# run again at any time, and does only what is missing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
export DEBIAN_FRONTEND=noninteractive

stop() {
    echo "setup.sh: $*" >&2
    exit 1
}

as_root() {
    if [ "$(id -u)" = 0 ]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo --preserve-env=DEBIAN_FRONTEND "$@"
    else
        stop "run it as root, or install sudo: '$*' needs it"
    fi
}

missing_packages() {
    local package
    for package in $(sed 's/#.*//' apt-packages.txt); do
        dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null |
            grep -qx installed || echo "$package"
    done
}

install_packages() {
    local missing
    command -v apt-get >/dev/null ||
        stop "no apt-get here: install what apt-packages.txt names in this system's own way"
    missing=$(missing_packages)
    [ -n "$missing" ] || return 0
    echo "setup.sh: installing" $missing
    as_root apt-get update --quiet
    # shellcheck disable=SC2086  # a list
    as_root apt-get install --quiet --yes --no-install-recommends \
        -o DPkg::Lock::Timeout=600 -o Dpkg::Use-Pty=0 $missing
}

make_venv() {
    local stamp=.venv/installed-requirements.txt
    cmp --silent requirements.txt "$stamp" && .venv/bin/python -c '' 2>/dev/null && return 0
    echo "setup.sh: making .venv"
    /usr/bin/python3 -m venv --clear .venv
    .venv/bin/python -m pip install --quiet --disable-pip-version-check --requirement requirements.txt
    cp requirements.txt "$stamp"
}

# Minimal images (docker.io/debian:12-slim) drop /usr/share/doc while installing, and the meshes
# with it: then they are taken from the package file itself.
unpack_meshes() (
    local target=data/meshes/cgal archive=usr/share/doc/libcgal-dev/data.tar.gz root=/
    [ -e "$target/.complete" ] && return 0
    echo "setup.sh: unpacking meshes into $target"
    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch"' EXIT
    if [ ! -e "/$archive" ]; then
        chmod 755 "$scratch"
        download() (cd "$scratch" && apt-get download --quiet -o APT::Sandbox::User=root libcgal-demo)
        download || { as_root apt-get update --quiet && download; }
        dpkg-deb --extract "$scratch"/libcgal-demo_*.deb "$scratch/root"
        root=$scratch/root
    fi
    rm -rf "$target"
    mkdir -p "$target"
    tar --extract --gzip --file "$root/$archive" --directory "$target" --strip-components=2 \
        --no-same-owner data/meshes
    touch "$target/.complete"
)

install_packages
make_venv
unpack_meshes
echo "setup.sh: ready"
