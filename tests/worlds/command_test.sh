#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# command_test.sh WORLDS ROOT: command-line tests of the program `worlds` and of tools/worlds, which
# refuses wrong use before a build.
set -u
program=$1 tool=$2/tools/worlds
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failed=0

# expect CODE PATTERN COMMAND...: checks the exit code and one line of the output (both streams).
expect() {
    local code=$1 pattern=$2 got
    shift 2
    output=$(timeout 60 "$@" 2>&1)
    got=$?
    if ((got != code)) || ! grep -Eq -- "$pattern" <<<"$output"; then
        printf 'FAILED: %s\n  exit code %s, expected %s; no line like: %s\n%s\n' \
            "$*" "$got" "$code" "$pattern" "$output"
        failed=1
    fi
}

mkdir folder && echo 'a text' >text && printf 'world 1 \ngravity 0' >half
over=18446744073709551616

expect 0 '^  sleep ' "$program" --help
expect 0 'of 1 worlds, 0 findings' "$program" --count 1 --seed 1
expect 0 '^world 4' "$program" --seed 18446744073709551615 --print
expect 0 '^world 4' "$program" --seed 18446744073709551615 --print --ordinary
"$program" --ordinary --seed 71 --print >seesaw
expect 0 'seesaw: no finding' "$program" --ordinary --replay seesaw
expect 0 'seesaw: no finding' "$program" --invariances --replay seesaw
expect 0 'of 1 worlds, 0 findings' "$program" --invariances --count 1 --seed 1
expect 0 '^see-saws +1 .* 0\.0%' "$program" --ordinary --count 1 --seed 71
expect 2 'folder is a folder' "$program" --replay folder
expect 2 'nowhere cannot be read' "$program" --replay nowhere
for file in text half; do
    expect 2 "$file is no saved world" "$program" --replay "$file"
done
# refuse PATTERN COMMAND...: wrong use is refused in one line.
refuse() {
    local pattern=$1
    shift
    expect 2 "$pattern" "$@"
    if [[ $output == *$'\n'* ]]; then
        printf 'FAILED: %s\n  more than one line:\n%s\n' "$*" "$output"
        failed=1
    fi
}

last=18446744073709551615
for wrong in '0' "$over" 'x' '-1' '1.5'; do
    refuse "^worlds: --count: must be a whole number from 1 to $last, but is '$wrong'. Try worlds" \
        "$program" --count "$wrong"
done
for wrong in "$over" 'x' '-1'; do
    refuse "^worlds: --seed: must be a whole number from 0 to $last, but is '$wrong'" \
        "$program" --seed "$wrong"
done
for wrong in 0 257 4294967297; do
    refuse "^worlds: --jobs: must be a whole number from 1 to 256, but is" "$program" --jobs "$wrong"
done
refuse '^worlds: --seed \+ --count - 1, the last seed, must be below' \
    "$program" --seed "$last" --count 2
refuse '^worlds: .*--frob' "$program" --frob
refuse '^worlds: --seed' "$program" --seed
for other in '--seed 1' '--count 1' '--shrink' '--jobs 1' '--print'; do
    # shellcheck disable=SC2086 # several words
    refuse "^worlds: --[a-z]+ excludes --[a-z]+" "$program" --replay text $other
done
refuse '^worlds: --[a-z]+ excludes --[a-z]+' "$program" --print --count 2
refuse '^worlds: --[a-z]+ excludes --[a-z]+' "$program" --ordinary --invariances
refuse '^worlds: --into requires --shrink' "$program" --into folder

expect 0 'tests/worlds/known' "$tool" --help
expect 2 'folder is a folder' "$tool" --replay folder
expect 2 'no readable file nowhere' "$tool" --replay nowhere
expect 2 'text is no saved world' "$tool" --replay text
for wrong in '--count 0' '--count 00' "--count $over" '--count x'; do
    # shellcheck disable=SC2086
    expect 2 'count must be a whole number from 1' "$tool" $wrong
done
for wrong in "--seed $over" '--seed -1' '--seed 99999999999999999999999'; do
    # shellcheck disable=SC2086
    expect 2 'seed must be a whole number' "$tool" $wrong
done
refuse '^tools/worlds: --precision must be' "$tool" --precision half
refuse '^tools/worlds: .*the last seed' "$tool" --count 2 --seed "$last"
refuse '^tools/worlds: --invariances excludes --ordinary' "$tool" --ordinary --invariances
refuse '^tools/worlds: --box2d3 requires --ordinary' "$tool" --box2d3 folder
refuse '^tools/worlds: --box2d3: no Box2D 3 is installed' "$tool" --ordinary --box2d3 folder
for other in '--seed 1' '--count 5' '--shrink'; do
    # shellcheck disable=SC2086
    refuse "^tools/worlds: --replay judges one saved world, without ${other%% *}" \
        "$tool" --replay half $other
    # shellcheck disable=SC2086
    refuse "^tools/worlds: --replay judges one saved world, without ${other%% *}" \
        "$tool" $other --replay half
done
refuse '^tools/worlds: --replay needs a value' "$tool" --replay
refuse '^tools/worlds: unknown option: extra' "$tool" extra
exit $failed
