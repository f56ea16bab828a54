#!/usr/bin/env bash
# launcher_test.sh LAUNCHER: what the launcher decides, with stand-ins for dpkg, apt, sudo, CMake and the program.
set -uo pipefail

launcher=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# expect STATUS PATTERN DESCRIPTION: about the last run.
expect() {
    if [[ $status != "$1" || ! $output =~ $2 ]]; then
        printf 'FAILED: %s\n  expected status %s and /%s/\n  status %s, output:\n%s\n' "$3" "$1" "$2" "$status" "$output"
        failures=$((failures + 1))
    fi
}
run() {
    output=$("$@" 2>&1 </dev/null)
    status=$?
}

# A checkout in a folder with a blank in its name; the stand-ins note their calls in $work/calls.
project="$work/a project"
mkdir -p "$project/core" "$project/visualizer" "$project/bench" "$work/bin"
cp "$launcher" "$project/rayscope"
touch "$project/CMakeLists.txt" "$project/CMakePresets.json"
stand_in() {
    printf '#!/usr/bin/env bash\necho "%s $*" >>"%s/calls"\n%s\n' "$1" "$work" "$2" >"$work/bin/$1"
    chmod +x "$work/bin/$1"
}
# shellcheck disable=SC2016 # expands in the stand-in
all_installed='for name in "${@:3}"; do if [[ $name != "${ABSENT-}" ]]; then echo "$name installed"; fi; done'
stand_in dpkg-query "$all_installed"
stand_in apt-get ''
stand_in sudo 'exit 1'
# shellcheck disable=SC2016 # expands in the stand-in
stand_in cmake '
while (($# > 0)); do
    case $1 in
        -B) folder=$2; mkdir -p "$folder/bin"; touch "$folder/build.ninja" ;;
        --build) folder=$2
            if [[ -n ${BROKEN-} ]]; then echo "an error of the compiler"; exit 1; fi
            mkdir -p "$folder/bin"
            for program in rayscope rayscope-bench lesson_csg; do
                printf "#!/usr/bin/env bash\npwd\nprintf \"<%%s>\" \"\$@\"\nexit 7\n" >"$folder/bin/$program"
                chmod +x "$folder/bin/$program"
            done ;;
    esac
    shift
done'
export PATH=$work/bin:$PATH
unset RAYSCOPE_VISUALIZER
calls() { grep -c "^$1" "$work/calls" 2>/dev/null; }
chmod -R a+rwX "$work"

run bash -n "$launcher"
expect 0 '' 'bash can read it'
if command -v shellcheck >/dev/null; then
    run shellcheck "$launcher"
    expect 0 '' 'shellcheck finds nothing'
fi

run "$project/rayscope" help
expect 0 'Usage:.*step.*render' 'help works before anything is set up'
run "$project/rayscope"
expect 0 'Usage:' 'no command means help'
run "$project/rayscope" stpe
expect 2 "did you mean 'step'" 'an unknown command names the near match'
run "$project/rayscope" xyzzy
expect 2 "unknown command 'xyzzy'; ./rayscope help" 'an unknown command without one'
run "$project/rayscope" setup --sci
expect 2 "unknown option '--sci'" 'an unknown option of setup'
if [[ -e $project/build ]]; then
    echo 'FAILED: these left something behind'
    failures=$((failures + 1))
fi

cd "$work" || exit 1
ln -s "a project/rayscope" link
run ./link step 'a b' '' '*' --no-vtk
expect 7 "$work
<step><a b><><\*><--no-vtk>" 'arguments, folder and exit code pass through, also by a link'
builds=$(calls 'cmake --build')
run "$project/rayscope" step
expect 7 '<step>$' 'a second run'
if [[ $(calls 'cmake --build') != "$builds" || $(calls dpkg-query) != 1 ]]; then
    echo 'FAILED: a second run neither builds nor asks for packages'
    failures=$((failures + 1))
fi
sleep 0.02
touch "$project/core/new.cpp"
run env BROKEN=yes "$project/rayscope" step
expect 1 'an error of the compiler.*could not build' 'a failing build ends with its log'
run "$project/rayscope" help step
expect 7 '<step><--help>' 'help COMMAND asks the program'
if (($(calls 'cmake --build') <= builds)); then
    echo 'FAILED: a newer source is built'
    failures=$((failures + 1))
fi

builds=$(calls 'cmake --build')
run "$project/rayscope" bench accuracy -o 'a b.json'
expect 7 '<accuracy><-o><a b.json>$' 'bench runs a program of its own'
run "$project/rayscope" bench
run "$project/rayscope" help bench
expect 7 '<--help>$' 'help bench asks it'
if [[ $(calls 'cmake --build') != $((builds + 1)) || $(calls 'cmake --build .* --target bench/program/all') != 1 ]]; then
    echo 'FAILED: bench is built once, and nothing else'
    failures=$((failures + 1))
fi
sleep 0.02
touch "$project/bench/new.cpp"
run "$project/rayscope" bench
if [[ $(calls 'cmake --build') != $((builds + 2)) ]]; then
    echo 'FAILED: a newer benchmark is built'
    failures=$((failures + 1))
fi

mkdir -p "$project/chapters/02_csg"
touch "$project/chapters/02_csg/lesson.cpp"
run "$project/rayscope" lesson csgg
expect 2 'expected one of: csg$' 'an unknown lesson names those that exist'
run "$project/rayscope" help lesson
expect 0 'names: csg$' 'help lesson names them, too'
run "$project/rayscope" lesson csg
expect 7 '<>$' 'a lesson is a program of its own'

# Someone who may not install. Root becomes nobody for this.
as_nobody=()
if ((EUID == 0)); then as_nobody=(setpriv --reuid=65534 --regid=65534 --clear-groups); fi
chmod -R a+rwX "$work"
rm -rf "$project/build"
run env ABSENT=libvtk9-dev "${as_nobody[@]}" "$project/rayscope" step
expect 1 'must run:  apt-get install --no-install-recommends libvtk9-dev.*without:  ./rayscope --no-vtk step' \
    'missing VTK offers the build without pictures'
run env ABSENT=g++ "${as_nobody[@]}" "$project/rayscope" step
expect 1 'must run:  apt-get install --no-install-recommends g\+\+$' 'a missing compiler offers nothing'
run env ABSENT=libvtk9-dev "${as_nobody[@]}" "$project/rayscope" --no-vtk step
expect 7 '<step>' 'the build without pictures'
run env ABSENT=libvtk9-dev "${as_nobody[@]}" "$project/rayscope" step
expect 7 '<step>' 'it is remembered'
if [[ -n $(calls apt-get) && $(calls apt-get) != 0 ]]; then
    echo 'FAILED: nothing is installed by someone who may not'
    failures=$((failures + 1))
fi

if ((EUID == 0)); then
    rm -rf "$project/build"
    run env ABSENT=libvtk9-dev "$project/rayscope" step
    expect 7 'to be installed: libvtk9-dev.*<step>' 'root installs, and is told what'
    if [[ $(calls 'apt-get .*install -y --no-install-recommends libvtk9-dev') != 1 ]]; then
        echo 'FAILED: exactly what is missing is installed'
        failures=$((failures + 1))
    fi
fi

rm -rf "$project/build"
chmod a-w "$project"
run "${as_nobody[@]}" "$project/rayscope" step
expect 1 'cannot write to .*/a project/build: copy the project' 'a read-only checkout'
chmod u+w "$project"

if ((failures > 0)); then exit 1; fi
echo 'all launcher checks hold'
