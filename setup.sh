#!/usr/bin/env bash
# Installs what Plumbline is built with: the Debian packages listed here, and nothing else. Says what it
# installs; silent and instant when all are present.
set -euo pipefail

packages=(
  # tools
  g++ cmake ninja-build ccache git python3
  # the packages that the mechanics stand on
  libeigen3-dev libboost-dev libgmp-dev libmpfr-dev libmpfi-dev
  # symbolic algebra
  libginac-dev
  # command line, formats, text
  libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libcsv-dev libfmt-dev libssl-dev libkainjow-mustache-dev
  # least squares
  libceres-dev
  # tests
  doctest-dev librapidcheck-dev python3-jsonschema
  # the rig of the blind trial
  libmujoco-dev
  # pages, in a browser
  chromium chromium-driver python3-selenium
  # drawings, at run time
  gnuplot-nox
)

# what the benchmarks compare with: ./setup.sh --bench
peers=(liblapack-dev libopenblas-dev libspectra-dev python3-scipy auto-07p gfortran)
[ "${1:-}" != --bench ] || packages+=("${peers[@]}")

# what the proofs are checked with: ./setup.sh --proofs
provers=(coq libcoq-mathcomp-ssreflect libcoq-mathcomp-algebra libcoq-mathcomp-field libcoq-mathcomp-real-closed
         libcoq-mathcomp-zify libcoq-mathcomp-algebra-tactics ocaml-nox ocaml-findlib libzarith-ocaml-dev
         libyojson-ocaml-dev)
[ "${1:-}" != --proofs ] || packages+=("${provers[@]}")

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
[ "$(id -u)" = 0 ] || as_root=(sudo)
echo "setup: installing ${missing[*]}"
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -qq -y --no-install-recommends "${missing[@]}" >/dev/null
