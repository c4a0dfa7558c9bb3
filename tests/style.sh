#!/bin/sh
# The rules of style that a machine can check. Says everything that is wrong.
#
#   sh tests/style.sh build      (after the build: object files are looked at)
set -u
build=${1:-build}
found=$(mktemp)
trap 'rm -f "$found"' EXIT

flags='-std=c11 -D_POSIX_C_SOURCE=200809L -fopenmp -Isrc -Itests -fsyntax-only
-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wmissing-prototypes -Werror'
sources=$(find src tests -name '*.[ch]' | sort)
modules=$(find src -name '*.c' | sort)
headers=$(find src -name '*.h' | sort)
objects=$(find "$build/src" -name '*.o' 2>/dev/null | sort)

wrong() { # prefixes each line of the input with a rule; notes that it is broken
    sed "s/^/$1: /" >>"$found"
}

layout() {
    command -v clang-format >/dev/null || return
    # shellcheck disable=SC2086 # one word a file
    clang-format --dry-run $sources 2>&1 | grep 'warning:' |
        wrong 'not as clang-format lays it out'
}

# Every header compiles alone: it is the first that a module includes, which was
# compiled, or it is compiled here. And every module does with clang, too.
alone() {
    for header in $headers; do
        first=$(grep -m 1 '^#include' "${header%.h}.c" 2>/dev/null)
        [ "$first" != "#include \"${header#src/}\"" ] || continue
        for compiler in gcc clang; do
            command -v $compiler >/dev/null || continue
            # shellcheck disable=SC2086
            printf '#include "%s"\nextern int nothing;\n' "${header#src/}" |
                $compiler $flags -x c - 2>&1 | grep -E 'error:' |
                wrong "header does not compile alone ($compiler)"
        done
    done
}

clang_too() {
    command -v clang >/dev/null || return
    # shellcheck disable=SC2086
    clang $flags $modules $(find tests -name '*.c') 2>&1 | grep -E 'error:' |
        wrong 'clang objects'
}

# A room knows itself and earlier ones; some not even all of these.
rooms() {
    grep -rn --include='*.[ch]' '^#include "' src | awk -F'[:/"]' '
    BEGIN {
        n = split("base mesh linear fluid particles averaging exchange effects" \
                  " output scene", order, " ")
        for (i = 1; i <= n; i++) rank[order[i]] = i
        apart["linear mesh"]; apart["particles fluid"]; apart["averaging fluid"]
        apart["output fluid"]; apart["output exchange"]
    }
    $2 != "main.c" { # src/room/file:line:#include "other/file"
        room = $2; other = $6
        if (rank[other] == 0 || rank[other] > rank[room] ||
            (room " " other) in apart)
            print $0
    }' | wrong 'room includes one it may not know'
}

# An exported name begins with its module: its own file, or a header of its
# room that several files stand behind.
names() {
    # shellcheck disable=SC2086
    nm -A -g --defined-only $objects | awk -v headers="$headers" '
    BEGIN { # behind["src/room"]: a pattern of its headers
        n = split(headers, h, " |\n")
        for (i = 1; i <= n; i++) {
            split(h[i], part, "[/.]")
            behind[part[2]] = behind[part[2]] part[3] "|"
        }
    }
    { # build/src/room/file.o:0000 T name
        n = split($1, part, "[/:]")
        if (part[n - 2] == "src") next # main
        sub(/\.o$/, "", part[n - 1])
        own = "^(" behind[part[n - 2]] part[n - 1] ")(s?_.*|s?)$"
        if ($3 !~ own) print $1 " " $3
    }' | wrong 'exported name without its module'
}

# Constant tables of pointers are relocated (.data.rel.ro); what changes while
# the program runs is in .data or .bss.
variables() {
    # shellcheck disable=SC2086
    nm -A -f sysv $objects | awk -F'|' '
        $7 ~ /^\.(data|bss|tdata|tbss)/ && $7 !~ /^\.data\.rel\.ro/ {
            print $1
        }' | wrong 'variable at file scope that may change'
}

lengths() {
    for module in $modules; do
        lines=$(wc -l <"$module")
        [ "$lines" -le 400 ] || echo "$module: $lines lines" |
            wrong 'module of more than 400 lines'
        awk -v file="$module" '
            /^[a-z].*\(/ { start = NR }
            /^}/ { if (start && NR - start + 1 > 60)
                       print file ":" start ": " NR - start + 1 " lines"
                   start = 0 }' "$module" |
            wrong 'function of more than 60 lines'
    done
}

# A cast of a real number beyond the range of the whole one gives nonsense: only
# base/number makes one of the other. clang knows the type of what is cast.
casts() {
    grep -n -E '\<l?l(round|rint)[fl]?\(' $modules $headers |
        wrong 'whole number that number.h did not make'
    command -v clang >/dev/null || return
    for module in $(grep -l -E '\((int|long|unsigned|u?int[0-9]*_t|size_t)\)' \
        $modules); do
        # shellcheck disable=SC2086
        clang $flags -fno-color-diagnostics -Xclang -ast-dump "$module" \
            2>/dev/null | awk -v module="$module" '
            /^[|`]-FunctionDecl/ { mine = $0 !~ / number_(int|long|clamped) / }
            /CStyleCastExpr.*<FloatingToIntegral>/ && mine { print module }'
    done | uniq -c | wrong 'cast of a real number, which number.h does'
}

text() {
    grep -rn --include='*.[ch]' '^ *# *if' src |
        grep -v -E '#ifndef [A-Z0-9_]+_H$|_OPENMP' | wrong 'code behind #if'
    for module in $modules $(find tests -name '*.c'); do
        head -1 "$module" | grep -q 'SPDX-License-Identifier: GPL-3.0-or-later' ||
            echo "$module" | wrong 'no licence in the first line'
    done
}

layout
alone
clang_too
rooms
names
variables
lengths
casts
text
if [ -s "$found" ]; then
    cat "$found"
    echo "style: $(wc -l <"$found") things are not as they should be"
    exit 1
fi
echo "style: as it should be"
