#!/bin/sh
# The core is the rooms' own files: without any folder they build a program that
# runs the small bed with the means of the whole one, and they pass the tests
# that need no folder. A folder is added to the core with no others than its
# models.txt names, and is taken away from the whole with no others than those
# that name it.
#
#   sh tests/core.sh build            the core
#   sh tests/core.sh build folders    each folder alone, added to it, and each
#                                     folder alone, taken away
set -u
build=${1:-build}
extent=${2:-core}
core=$build/core
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
facts=0
# All folders, and rooms aside, of the whole program.
tr ' ' '\n' <"$build/folders" | sed 's/$/\//' >"$work/folders"
export OMP_NUM_THREADS=1

holds() { # name, 0 if it holds; says what $work/said has if it does not
    if [ "$2" -eq 0 ]; then
        facts=$((facts + 1)) && echo "    $1"
    else
        echo "FAILED $1:" && cat "$work/said"
        failed=$((failed + 1))
    fi
}

made() { # folders, target...
    folders=$1
    shift
    ${MAKE:-make} -k FOLDERS="$folders" B="$core" "$@" >"$work/said" 2>&1
}

# What a folder needs, and what that needs; each once.
with_needs() {
    list=$1
    for folder in $list; do
        [ -f "$folder/models.txt" ] || continue
        others=$(sed -n 's/^needs //p' "$folder/models.txt")
        for other in $others; do
            case " $list " in *" $other "*) ;; *) list="$list $other" ;; esac
        done
    done
    if [ "$list" = "$1" ]; then echo "$list"; else with_needs "$list"; fi
}

# A test program needs the folders whose headers it reads, and those that it
# names in a line `needs src/...` of a comment, because it asks for their models
# by name.
needs() { # tests/test_x.c
    ${CC:-gcc} -std=c11 -D_POSIX_C_SOURCE=200809L -MM -Isrc -Itests "$1" |
        tr ' ' '\n' | grep -F -f "$work/folders"
    sed -n 's/^.*\<needs \(src\/[a-z_\/]*\).*/\1/p' "$1"
}

run() { # program, folder for the results, setting...
    winnow=$1 dir=$2
    shift 2
    rm -rf "$dir" # without a list of its files a run leaves them in the way
    "$winnow" run cases/small-bed.cfg -o "$dir" --quiet "$@" >"$work/said" 2>&1
}

# The scalar loops and the fast ones round differently, and each solver stops at
# its tolerance: the means differ by up to 3e-6. A hundredth more friction moves
# each of them by 2.8e-4 or more.
means_are_the_same() { # two histories
    awk -F, '
    FNR == 1 { run++; for (i = 1; i <= NF; i++) column[run, $i] = i; next }
    {
        n = split("pressure_drop [Pa];kinetic_energy_fluid [J];" \
                  "kinetic_energy_particles [J];granular_temperature [m2/s2];" \
                  "mean_height [m];max_overlap [-];eps_f_lowest [-]", name, ";")
        for (k = 1; k <= n; k++) sum[run, k] += $column[run, name[k]]
        rows[run]++
    }
    END {
        wrong = rows[1] != rows[2] || rows[1] < 100
        for (k = 1; k <= n; k++) {
            ratio = sum[1, k] / sum[2, k]
            if (!(ratio > 1 - 1e-4 && ratio < 1 + 1e-4)) {
                print name[k] ": " ratio " of that of the whole program"
                wrong = 1
            }
        }
        exit wrong
    }' "$1" "$2" >"$work/said"
}

the_core() {
    made "" "$core/winnow"
    holds the_rooms_own_files_build_a_program $?
    [ "$failed" -eq 0 ] || return
    run "$core/winnow" "$work/core" -s output.end=0.05
    holds the_core_runs_the_small_bed $?
    run "$build/winnow" "$work/whole" -s output.end=0.05
    means_are_the_same "$work/core/history.csv" "$work/whole/history.csv"
    holds its_means_are_those_of_the_whole_program $?
}

refuses() { # name, what it says, arguments
    name=$1 what=$2
    shift 2
    "$core/winnow" "$@" >"$work/said" 2>&1
    code=$?
    grep -qF "$what not in this build, which leaves out src/" "$work/said" &&
        [ $code -eq 2 ] && [ "$(wc -l <"$work/said")" -eq 1 ]
    holds "$name" $?
}

its_messages() {
    bed="run cases/small-bed.cfg -o $work/none -s"
    # shellcheck disable=SC2086 # words
    {
        refuses a_key_of_a_folder_is_not_in_the_core "particles.sinks:" \
            $bed 'particles.sinks=({side="top";})'
        refuses a_model_of_a_folder_is_not_in_the_core "dpvm is" \
            $bed averaging.method=dpvm
        refuses an_effect_of_a_folder_is_not_in_the_core "effects.virtual_mass:" \
            $bed 'effects.virtual_mass={}'
        refuses a_command_of_a_folder_is_not_in_the_core "check is" \
            check cases/small-bed.cfg
    }
    [ ! -e "$work/none" ]
    holds what_the_core_refuses_writes_nothing $?
    ! made src/case/surfaces "$core/src/models.c" &&
        grep -q "src/case/surfaces needs src/dem/surfaces" "$work/said"
    holds a_folder_without_what_it_needs_is_refused_by_name $?
    made "" "$core/src/models.c"
}

its_tests() {
    programs=
    for test in tests/test_*.c; do
        [ -n "$(needs "$test")" ] ||
            programs="$programs $core/tests/$(basename "$test" .c)"
    done
    # shellcheck disable=SC2086 # words
    made "" $programs
    holds the_tests_that_need_no_folder_link_with_the_core $?
    for program in $programs; do
        [ -x "$program" ] || continue
        sh tests/run.sh "$program" >"$work/said" 2>&1
        holds "$(basename "$program")" $?
    done
}

each_folder() {
    list=$(cat "$build/folders")
    for folder in $list; do
        all=$(with_needs "$folder")
        made "$all" "$core/winnow" &&
            run "$core/winnow" "$work/folder" -s output.end=0.002 \
                -s particles.bed.settle=0.001
        holds "the_core_with_$folder ($(echo "$all" | wc -w))" $?
    done
    made "" "$core/winnow" || holds the_core_again $?
}

# The folders that need one of the list, and those that need these; each once.
with_those_that_need() {
    list=$1
    for folder in $(cat "$build/folders"); do
        case " $list " in *" $folder "*) continue ;; esac
        [ -f "$folder/models.txt" ] || continue
        for other in $(sed -n 's/^needs //p' "$folder/models.txt"); do
            case " $list " in *" $other "*) list="$list $folder" && break ;; esac
        done
    done
    if [ "$list" = "$1" ]; then echo "$list"; else with_those_that_need "$list"; fi
}

without_each_folder() {
    for folder in $(cat "$build/folders"); do
        out=$(with_those_that_need "$folder")
        left=
        for other in $(cat "$build/folders"); do
            case " $out " in *" $other "*) ;; *) left="$left $other" ;; esac
        done
        made "$left" "$core/winnow" &&
            run "$core/winnow" "$work/without" -s output.end=0.002 \
                -s particles.bed.settle=0.001
        holds "the_whole_without_$folder ($(echo "$out" | wc -w))" $?
    done
    made "" "$core/winnow" || holds the_core_again $?
}

if [ "$extent" = folders ]; then
    each_folder
    without_each_folder
else
    the_core
    [ "$failed" -eq 0 ] && its_messages && its_tests
fi
echo "core: $facts passed, $failed failed"
[ "$failed" -eq 0 ]
