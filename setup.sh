#!/usr/bin/env bash
# Installs what Plumbline needs: the Debian packages listed here, and nothing else. Says what it installs; silent and
# instant when all are present.
#
#   ./setup.sh           what the program is built with
#   ./setup.sh --tests   and what its tests need
#   ./setup.sh --python  and what the Python package needs
#   ./setup.sh --mpi     and what shares work among machines
#   ./setup.sh --bench   and what the benchmarks compare with
#   ./setup.sh --docs    and what writes the documents as a site
#   ./setup.sh --fuzz    and the compiler of the fuzz targets
#   ./setup.sh --proofs  and what the proofs in proofs/coq are checked with
set -euo pipefail

program=(
  # tools
  g++ cmake ninja-build git python3
  # the packages that the mechanics stand on
  libeigen3-dev libboost-dev libgmp-dev libmpfr-dev libmpfi-dev
  # symbolic algebra
  libginac-dev
  # command line, formats, text
  libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libcsv-dev libfmt-dev libssl-dev libkainjow-mustache-dev libpugixml-dev zlib1g-dev
  # the page of `plumbline serve`
  libcpp-httplib-dev pkg-config
  # expressions of the effects that users state
  libmuparser-dev
  # figures
  gnuplot-nox
)
# what checks the proofs in proofs/coq
proofs=(coq libcoq-mathcomp-ssreflect libcoq-mathcomp-algebra libcoq-mathcomp-field libcoq-mathcomp-real-closed
        libcoq-mathcomp-zify libcoq-mathcomp-algebra-tactics ocaml-nox ocaml-findlib libzarith-ocaml-dev
        libyojson-ocaml-dev)
mpi=(openmpi-bin libopenmpi-dev)
# what judges our reading and writing of simulators' models
models=(libmujoco-dev libsdformat-dev)
python=(
  pybind11-dev python3-dev python3-numpy python3-pip python3-setuptools python3-wheel python3-venv
  # what it uses where it finds it, and its notebooks
  python3-pandas python3-matplotlib python3-mpmath python3-openpyxl jupyter-nbconvert python3-ipykernel
)
# the site: the reference
docs=(doxygen)
tests=(
  ccache doctest-dev librapidcheck-dev python3-jsonschema python3-mpmath clang-format
  # the simulated bench of the blind trial, and the models of simulators
  "${models[@]}"
  # many machines
  "${mpi[@]}"
  # the Python package
  "${python[@]}" python3-pytest mypy
  # pages, in a browser
  chromium chromium-driver python3-selenium poppler-utils
  # packages and what is installed, as a user meets them
  dpkg-dev man-db zsh
  # the benches of the blind trial
  python3-scipy
  # the site
  "${docs[@]}"
)
fuzz=(clang)
bench=(liblapack-dev libopenblas-dev libspectra-dev libflint-dev libflint-arb-dev phcpack python3-scipy auto-07p gfortran)

packages=("${program[@]}")
case "${1:-}" in
  "") ;;
  --tests) packages+=("${tests[@]}") ;;
  --python) packages+=("${python[@]}") ;;
  --mpi) packages+=("${mpi[@]}") ;;
  --bench) packages+=("${bench[@]}") ;;
  --docs) packages+=("${docs[@]}") ;;
  --fuzz) packages+=("${fuzz[@]}") ;;
  --proofs) packages+=("${proofs[@]}") ;;
  *)
    echo "setup: found $1, expected nothing, --tests, --python, --mpi, --bench, --docs, --fuzz or --proofs" >&2
    exit 2
    ;;
esac

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
