#!/usr/bin/env bash
# Run once, when Gradescope makes the machine's image: Debian 12.
set -euo pipefail
apt-get update
DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
    g++ cmake ninja-build libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libfmt-dev libtinyobjloader-dev \
    libtbb-dev libpng-dev libopenexr-dev libglm-dev bubblewrap libseccomp-dev
source=${AUTOGRADER:-/autograder}/source
cmake -S "$source/rayscope" -B "$source/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DRAYSCOPE_VISUALIZER=OFF -DRAYSCOPE_BENCH=OFF -DBUILD_TESTING=OFF
cmake --build "$source/build" --target rayscope-exercises
chmod 600 "$source/options"
