#!/bin/sh
# SPDX-License-Identifier: MIT
# headless_test.sh APART_HEADLESS REPLAYS: command-line tests of apart-headless, run in another
# folder.
set -u
program=$1 replays=$2
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failed=0

# expect CODE PATTERN COMMAND...: checks the exit code and one line of the output (both streams).
expect() {
    code=$1 pattern=$2
    shift 2
    output=$("$@" 2>&1)
    got=$?
    if [ "$got" -ne "$code" ] || ! printf '%s\n' "$output" | grep -Eq -- "$pattern"; then
        printf 'FAILED: %s\n  exit code %s, expected %s; no line like: %s\n%s\n' \
            "$*" "$got" "$code" "$pattern" "$output"
        failed=1
    fi
}

json='^\{"level": "[a-z_]+", "seed": [0-9]+, "ticks": [0-9]+, "result": "[a-z]+", "score": [0-9]+, '
json="$json"'"lives": [0-9]+, "blocksLeft": [0-9]+, "stateHash": "[0-9a-f]{16}"'

expect 0 'Usage' "$program" --help
expect 0 '^aPart [0-9]+\.[0-9]+\.[0-9]+, rules [0-9]+$' "$program" --version
expect 0 'APART_ASSETS names another folder of assets' "$program" --help
expect 0 '^first_light ' "$program" levels
expect 0 "$json\\}\$" "$program" bot --level mitosis --seed 7 --ticks 900 --record a.replay --json
expect 0 'All 15 hashes agree' "$program" verify a.replay
expect 0 "$json, \"hashesChecked\": 15, \"firstDifference\": null\\}\$" \
    "$program" verify a.replay --json
expect 0 "$json, \"expectationsFailed\": 0\\}\$" \
    "$program" replay "$replays/keystone_caught.replay" --json

# What happens, by tick; and the hash lines of a handwritten replay.
expect 0 '^166 broke block 169 .* impulse 19.5.* pieces 5 ' \
    "$program" trace "$replays/pattern_slats.replay" --from 160
expect 0 '^166 pieceMomentumY = 307' \
    "$program" trace "$replays/pattern_slats.replay" --field pieceMomentumY
expect 0 '^# tick event ' "$program" trace "$replays/pattern_slats.replay" --to 1
expect 0 '^[0-9]+ struck (wall|block|paddle) at ' "$program" trace "$replays/pattern_slats.replay"
expect 0 '^# Nothing happens from tick 1 to 2' \
    "$program" trace "$replays/pattern_slats.replay" --from 1 --to 2
expect 2 'from 9 is after --to 8' "$program" trace a.replay --from 9 --to 8
expect 0 '^# The replay ends at tick 900, before tick 901' "$program" trace a.replay --from 901
expect 0 '^# The replay ends at tick 900, before tick 99999' "$program" trace a.replay --to 99999
"$program" trace a.replay | grep -q '^# The replay ends' &&
    { echo 'FAILED: trace to the end says that the replay ends before'; failed=1; }
expect 2 'Try apart-headless trace --help' "$program" trace a.replay --from x
expect 2 'Try apart-headless bot --help' "$program" bot --nosuch
expect 2 'Try apart-headless --help' "$program" nosuch
expect 2 'there is no field nothing' "$program" trace a.replay --field nothing
mkdir levels && cp "$replays"/levels/patterns.toml levels/ 2>/dev/null
grep -v '^hash' "$replays/pattern_slats.replay" >slats.replay
expect 0 '^slats.replay: hash 42 ' "$program" hash slats.replay
cmp -s slats.replay "$replays/pattern_slats.replay" ||
    { echo 'FAILED: the replaced hash lines differ'; failed=1; }
expect 2 'was recorded, and has the hashes' "$program" hash a.replay

# A few bytes can hold ten hours of play: on a terminal each command shows its progress.
printf 'apart-replay 2\nlevel first_light\nseed 7\nhandwritten\nend 3000\n' >long.replay
if command -v script >/dev/null; then
    for command in 'replay long.replay' 'hash long.replay' 'trace long.replay >trace.txt'; do
        expect 0 'first_light  0:[0-9]+ of 0:25  score 0' \
            script -qec "$program $command" /dev/null
    done
fi
mkfifo pipe
expect 2 'pipe: is a pipe, a device or a socket, not a file' "$program" verify pipe
expect 2 'pipe: is a pipe, a device or a socket, not a file' \
    "$program" bot --ticks 10 --record pipe

# A level of a file: its replay names it, and needs the file.
sed 's/^title = .*/title = "Mine"/; s/^lives = .*/lives = 2/' "$replays/levels/patterns.toml" >alpha.toml
expect 0 '^alpha, seed 1: ' "$program" bot --level alpha.toml --ticks 300 --record alpha.replay
expect 2 'there is no level alpha' "$program" verify alpha.replay
expect 0 'All 5 hashes agree' "$program" verify alpha.replay --level alpha.toml
expect 0 '^alpha, seed 1: ' "$program" replay alpha.replay --level alpha.toml
expect 0 '^[0-9]+ struck ' "$program" trace alpha.replay --level alpha.toml
expect 2 'nosuch.toml: ' "$program" verify alpha.replay --level nosuch.toml

# A generated level: its name in the replay suffices to play it again.
expect 0 "^endless:7:3, seed 5: " \
    "$program" bot --level endless:7:3 --seed 5 --ticks 900 --record endless.replay
expect 0 'All 15 hashes agree' "$program" verify endless.replay
# A run of several levels in one file, each verified; levels that are no run are refused.
"$program" bot --level endless:7:4 --seed 5 --ticks 300 --record next.replay >/dev/null
cat endless.replay next.replay >run.replay
expect 0 '^endless:7:3, seed 5: ' "$program" verify run.replay
expect 0 '^endless:7:4, seed 5: ' "$program" verify run.replay
expect 0 '^level endless:7:4$' "$program" trace run.replay --to 10
cat next.replay endless.replay >run.replay
expect 2 'not consecutive endless levels' "$program" verify run.replay
expect 0 '"level": "endless:9:1", "seed": 9' "$program" bot --level endless --seed 9 --ticks 10 --json
expect 2 'endless:7:0.*SEED from 0 to 4294967295 and a NUMBER from 1' "$program" bot --level endless:7:0
expect 2 '/nowhere: there are no levels in it' env APART_ASSETS=/nowhere "$program" levels

expect 0 'All 1 levels pass' "$program" lint first_light
expect 0 '"passed": true' "$program" lint first_light endless:7:3 --json
expect 1 'first_light: the bot.s game with seed 1 is not won after 0 s' \
    "$program" lint first_light --ticks 10
expect 2 'there is no level nowhere' "$program" lint first_light nowhere

# A second set of seeds: other games, the same in each run; unless told, the first seed is 1.
for part in --json '--difficulty --ticks 1200'; do
    for seeds in '' '--first-seed 1' '--first-seed 3' '--first-seed 3'; do
        # shellcheck disable=SC2086
        "$program" lint first_light $part --seeds 2 $seeds | cksum
    done >sums.txt
    [ "$(sed -n 1p sums.txt)" = "$(sed -n 2p sums.txt)" ] &&
        [ "$(sed -n 3p sums.txt)" = "$(sed -n 4p sums.txt)" ] &&
        [ "$(sed -n 1p sums.txt)" != "$(sed -n 3p sums.txt)" ] ||
        { echo "FAILED: lint $part --first-seed plays other games"; failed=1; }
done
expect 1 'first_light: the bot.s game with seed 4 is not won after 0 s' \
    "$program" lint first_light --ticks 10 --seeds 2 --first-seed 3
expect 0 '--first-seed .*0 - 1000000000' "$program" lint --help
for seed in -5 many 1000000001 99999999999; do
    expect 2 "--first-seed: Value $seed not in range 0 to 1000000000. Try apart-headless lint" \
        "$program" lint first_light --first-seed "$seed"
done
expect 0 '^\{"total": .*"ticks": 3000,.*"halts": 0, "escapes": 0, "bends": 0' \
    "$program" soak first_light --ticks 3000 --longest 1000 --endless 1 --json

expect 2 'not in range' "$program" soak --ticks -5
expect 2 'not in range' "$program" soak --first-seed -5

# A recording of a pure game states the mode.
expect 0 "$json\\}\$" "$program" bot --level first_light --mode pure --ticks 300 --record pure.replay \
    --json
expect 0 '^pure$' cat pure.replay
expect 0 'All 5 hashes agree' "$program" verify pure.replay

# Two recordings of the same game are bitwise equal.
"$program" bot --level mitosis --seed 7 --ticks 900 --record b.replay >/dev/null
cmp -s a.replay b.replay || { echo 'FAILED: two recordings of one game differ'; failed=1; }

# Each error is reported in one sentence.
expect 2 'there is no such file' "$program" replay nothing.replay
head -c 1000 a.replay >cut.replay
expect 2 '^apart-headless: cut.replay:[0-9]+: the file is cut off' "$program" verify cut.replay
sed 's/^seed 7$/seed 8/' a.replay >changed.replay
expect 2 'changed.replay:[0-9]+: the file was changed' "$program" verify changed.replay
grep -v '^digest' a.replay >bare.replay
expect 2 'bare.replay:[0-9]+: .*was edited: .*handwritten' "$program" verify bare.replay
sed 's/^rules/handwritten\nrules/' a.replay >both.replay
expect 2 'one that was edited has none' "$program" verify both.replay
sed -e 's/^seed 7$/seed 8/' -e 's/^digest .*/x/' -e '/^x$/d' -e 's/^rules/handwritten\nrules/' \
    a.replay >other.replay
expect 1 'tick 60 is the first whose hash differs' "$program" verify other.replay
expect 1 '^other.replay: the game diverges: tick 60 is the first' "$program" replay other.replay
cp "$replays/levels/keystones_caught.toml" levels/
sed 's/^expect 600   lives .*/expect 600 lives == 1/' "$replays/keystone_caught.replay" >unmet.replay
expect 1 '^unmet.replay:[0-9]+: expect 600 lives == 1, but lives is 8$' "$program" replay unmet.replay
expect 1 '^unmet.replay:[0-9]+: expect 600 lives == 1, but lives is 8$' "$program" verify unmet.replay
expect 0 'All [0-9]+ expectations are met' "$program" verify "$replays/keystone_caught.replay"
grep -v -e '^hash' -e '^expect' unmet.replay >empty.replay
expect 2 'there is no hash line and no expectation to verify' "$program" verify empty.replay
expect 2 'there is no level nowhere' "$program" bot --level nowhere
expect 2 'a whole number from 0 to 4294967295, not .99999999999' "$program" bot --seed 99999999999
expect 2 'level' "$program" bot --level=
expect 2 'Try apart-headless bot --help' "$program" bot --ticks many
expect 2 'A subcommand is required.*Try apart-headless --help' "$program"
expect 2 "^apart-headless: There is no command 'bogus'. Try apart-headless --help" "$program" bogus
expect 2 "There is no option '--bogus'" "$program" --bogus
expect 2 'not expected: bogus' "$program" bot bogus

# I2: what a file or a word holds reaches a terminal without its commands.
mkdir -p hostile/levels
sed -e 's/^title = .*/title = "Red \\u001b[31m\\u202etitle"/' \
    "$replays/levels/single.toml" >hostile/levels/single.toml
expect 2 'single.toml:2: title must be one line without control characters' \
    env APART_ASSETS="$PWD/hostile" "$program" levels
mark=$(printf 'a\033[31m\342\200\256b')
expect 2 "there is no field a.\[31m.b" "$program" trace a.replay --field "$mark"
expect 2 "There is no command 'a.\[31m.b'" "$program" "$mark"
expect 2 'a.\[31m.b: is not a level name' "$program" bot --level "$mark"
expect 2 'a.\[31m.b: there are no levels in it' env APART_ASSETS="/$mark" "$program" levels
for words in "trace a.replay --field" "" "bot --level" "replay" "verify" "lint"; do
    # shellcheck disable=SC2086
    if "$program" $words "$mark" 2>&1 | grep -q "$(printf '\033\|\342\200\256')"; then
        printf 'FAILED: "%s" prints the commands of its word\n' "$words"
        failed=1
    fi
done
if APART_ASSETS="$PWD/hostile" "$program" levels 2>&1 | grep -q "$(printf '\033')"; then
    echo 'FAILED: levels prints the commands of a title'
    failed=1
fi

# An output that is lost is told, be it short or long.
to_full() {
    "$program" "$@" >/dev/full
}
closed() {
    "$program" "$@" >&-
}
for sink in to_full closed; do
    expect 2 'written to its end|cannot write' $sink --help
    expect 2 'written to its end|cannot write' $sink levels
    expect 2 'written to its end|cannot write' $sink verify --json "$replays/won.replay"
    expect 2 'written to its end|cannot write' $sink replay "$replays/won.replay"
    expect 2 'written to its end|cannot write' $sink lint first_light
done
exit "$failed"
