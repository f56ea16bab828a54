#!/usr/bin/env bash
# extending_test.sh CHECKOUT PROGRAMS check|build: the patches of chapters/reference/extending.
# check: each applies to the project as it is, and includes what is there.
# build: all together, in a copy, built without optimization, and their tests.
set -euo pipefail

checkout=$1 programs=$2 what=$3
patches=$checkout/chapters/reference/extending
names=(generic stage effect exercise)
if ! command -v git >/dev/null; then
    echo 'not run: git is missing'
    exit 77
fi

copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
tar -C "$checkout" --exclude=./build --exclude=./.git -cf - . | tar -C "$copy" -xf -
cd "$copy" # no repository: git apply then takes the files as they are
for name in "${names[@]}"; do
    GIT_CEILING_DIRECTORIES=/ git apply --check "$patches/$name.diff" || { echo "FAILED: $name.diff does not apply any more" && exit 1; }
    GIT_CEILING_DIRECTORIES=/ git apply "$patches/$name.diff"
done
for file in core/generics/wedge.hpp core/extents/sorted.hpp tests/effects/glow_test.cpp exercises/1-07-nearest/solution.hpp; do
    [[ -f $file ]] || { echo "FAILED: no $file" && exit 1; }
done
while read -r header; do # one that has moved
    [[ -f $header ]] || { echo "FAILED: a patch includes $header, which is not there" && exit 1; }
done < <(sed -nE 's,^\+#include "((core|tests)/[^"]*)",\1,p' "$patches"/*.diff)
echo "all of ${names[*]} apply, one after the other"
if [[ $what == check ]]; then exit; fi

"$programs/rayscope-exercises" --exercises "$copy/exercises" verify 1-07-nearest

cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS=-O0 -DCMAKE_CXX_FLAGS_DEBUG= \
    -DRAYSCOPE_VISUALIZER=OFF >configure.log || { tail -n 20 configure.log && exit 1; }
cmake --build build --target rayscope tests_generics tests_agreement tests_effects >build.log || { tail -n 40 build.log && exit 1; }
build/bin/tests_generics --gtest_filter='Wedge.*' --gtest_brief=1
build/bin/tests_effects --gtest_filter='Glow.*' --gtest_brief=1
RAYSCOPE_EFFORT=0.2 build/bin/tests_agreement --gtest_filter='Agreement/1.*' --gtest_brief=1 # Sorted

cat >ember.toml <<'SCENE'
[camera]
eye = [4, -6, 3]
look_at = [0, 0, 0]
up = [0, 0, 1]
[materials.ember]
glow = [0.7, 0.2, 0.05]
[generics.ember]
shape = "wedge"
material = "ember"
SCENE
for stage in scan sorted; do build/bin/rayscope render ember.toml --size 64x48 --stage $stage -o $stage.pfm >/dev/null; done
cmp scan.pfm sorted.pfm
build/bin/rayscope explain ember.toml | grep "material 'ember' of 'ember' gives off light"
