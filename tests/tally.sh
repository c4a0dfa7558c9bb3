#!/bin/sh
# The continuous integration, .ci/run, on a Makefile whose parts pass, fail, stop
# early, do not compile or do not end: its exit code, and what its last lines say. And
# what .ci/install says where it cannot install.
#
#   sh tests/tally.sh
set -u
top=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failed=0
facts=0
mkdir .ci tests
cp "$top/.ci/run" .ci
cp "$top/tests/tally.awk" tests
unset MAKEFLAGS MAKELEVEL MFLAGS

# The parts of the Makefile; a test overrides some of them.
fine='@echo "    a_fact_of_five"; echo "    figures/25/25-late.txt"; echo "fine: 5 passed, 0 failed"'
wrong='@echo "FAILED of_three:"; echo "wrong: 2 passed, 1 failed"; exit 1'
early='@echo "    one_fact_and_no_sum"; exit 2'
breaks='@echo "x.c:3:1: error: no"; exit 1'
hangs='@sleep 30'

# fact NAME CODE LAST COMMANDS...: .ci/run ends with the code and its last line, if
# these are the commands of check, check-slow and check-distributed; the line above
# it names what $blamed says.
fact() {
    name=$1 code=$2 last=$3
    {
        printf 'check:\n\t@$(MAKE) -k checks\nchecks: first second\nfirst:\n\t%s\n' "$4"
        printf 'second:\n\t%s\ncheck-slow:\n\t@$(MAKE) -k slow\nslow: third\n' "$5"
        printf 'third:\n\t%s\ncheck-distributed:\n\t%s\n' "$6" "$7"
    } >Makefile
    sh .ci/run ${seconds:-60} >said 2>&1
    found=$?
    if [ $found -ne "$code" ] || [ "$(tail -n 1 said)" != "$last" ] ||
        { [ -n "$blamed" ] && [ "$(tail -n 2 said | head -n 1)" != "what failed: $blamed" ]; }; then
        echo "FAILED $name: code $found, not $code, and the last lines:"
        tail -n 3 said
        failed=$((failed + 1))
    else
        facts=$((facts + 1)) && echo "    $name"
    fi
}

told() { # NAME COMMAND...
    name=$1
    shift
    if "$@"; then
        facts=$((facts + 1)) && echo "    $name"
    else
        echo "FAILED $name:" && cat said
        failed=$((failed + 1))
    fi
}

blamed=
fact all_facts_are_counted_and_nothing_else 0 "20 passed, 0 failed" "$fine" "$fine" "$fine" "$fine"
fact a_part_without_facts_is_none 0 "10 passed, 0 failed" "$fine" "@echo skipped" "$fine" "@:"
said_why() { tail -n 2 said | grep -qx 'skipped: bare: no root'; }
skips='@echo "skipped: bare: no root"'
fact what_is_skipped_counts_as_nothing 0 "10 passed, 0 failed" "$fine" "$skips" "$fine" "@:"
told and_is_named said_why
blamed="wrong, third"
fact a_fact_of_a_slow_part_decides 1 "17 passed, 1 failed" "$fine" "$fine" "$wrong" "$fine"
blamed="wrong, second"
fact and_so_does_one_of_check 1 "17 passed, 1 failed" "$fine" "$wrong" "$fine" "$fine"
blamed="first"
fact what_ends_early_is_a_failure 1 "15 passed, 1 failed" "$early" "$fine" "$fine" "$fine"
blamed="wrong, first, second"
fact what_does_not_compile_is_one_beside_others 1 "12 passed, 2 failed" "$breaks" "$wrong" "$fine" "$fine"
seconds=2 blamed="make check, make check-slow, make check-distributed"
fact what_does_not_end_is_one 1 "5 passed, 3 failed" "$fine" "$hangs" "$hangs" "$hangs"

# A machine with the programs that are named, and of which apt-get and sudo do as the
# last words say: nothing but the first line that is printed tells what to type.
machine() { # user, program...
    rm -rf bin && mkdir bin
    for program in sh env grep tail cat mktemp rm; do
        ln -s "$(command -v $program)" bin
    done
    printf '#!/bin/sh\necho %s\n' "$1" >bin/id
    shift
    for program; do
        printf '#!/bin/sh\n%s\n' "${program#*:}" >"bin/${program%%:*}"
    done
    chmod +x bin/*
}
one_line() { # of .ci/install, with the part and nothing else on stderr
    part=$1
    shift
    PATH=$PWD/bin sh "$top/.ci/install" "$@" >out 2>said
    [ $? -eq 1 ] && [ "$(wc -l <said)" -eq 1 ] && grep -qF -- "$part" said
}
fails='for i in 1 2 3; do echo "E: no $i"; done; exit 100'
works='case $* in *--version) ;; *) '$fails' ;; esac'
machine 1000 "apt-get:$fails" "sudo:exit 1"
told a_build_without_packages_says_what_to_type \
    one_line 'are missing; type: sudo apt-get install gcc libc6-dev' build
told so_does_who_may_not_use_sudo one_line 'type: sudo apt-get install gcc' run
machine 1000 "apt-get:$fails"
told and_who_has_none one_line "type: su -c 'apt-get install gcc" run
machine 0 "apt-get:$works"
told and_who_has_no_network one_line 'installed (E: no 3); type: apt-get install gcc' run
machine 0
told and_who_has_another_system one_line 'what these Debian packages hold: gcc' run

echo "sums of the integration: $facts passed, $failed failed"
[ $failed -eq 0 ]
