# The last lines of .ci/run, from the logs of make: which parts failed, and how many
# facts passed and failed. Each part of a check ends with a line
#
#   NAME: N passed, N failed
#
# Where make stopped more often than such lines tell of failures, something did not
# compile or ended early: each of these is a failure, too. What says "skipped: why" is
# named, and counts as nothing.
#
#   awk -f tests/tally.awk LOG...
#
# The exit code is 1 if anything failed.
function add_part(name) {
    if (!(name in known)) parts[++n_parts] = name
    known[name] = 1
}
function end_log(    i) {
    if (cut != "") { # by the clock, which is one failure
        stopped = 0
        failed++
        add_part(cut)
    } else if (stopped > told) failed += stopped - told
    # make check stopped before its first part
    else if (ended_wrong && !told) failed++
    for (i = 1; i <= stopped; i++) add_part(target[i])
    stopped = told = ended_wrong = 0
    cut = ""
}
FNR == 1 { end_log() }
/^[^ ].*: [0-9]+ passed, [0-9]+ failed$/ {
    passed += $(NF - 3)
    failed += $(NF - 1)
    if ($(NF - 1) == 0) next
    told++
    name = $0
    sub(/: [0-9]+ passed, [0-9]+ failed$/, "", name)
    add_part(name)
}
/^FAILED / || /^[^ ]*:[0-9]+:[FE]:/ {
    if (++n_lines <= 20) line[n_lines] = substr($0, 1, 150)
}
/^skipped: / { print }
/^FAILED make / { ended_wrong = 1 }
/^FAILED make .*did not end/ { cut = "make " substr($3, 1, length($3) - 1) }
# make[1]: *** [Makefile:56: faults-slow] Error 1. What calls make again says so, too.
/^make[^ ]* \*\*\* / {
    name = $0
    sub(/^make[^ ]* \*\*\* (\[[^ ]* )?/, "", name)
    sub(/\].*/, "", name)
    if (name ~ /^(checks?|slow|check-slow|check-distributed|sanitized|sanitized-slow)$/ ||
        name ~ /^Waiting for unfinished/) next
    target[++stopped] = name
}
END {
    end_log()
    for (i = 1; i <= n_lines && i <= 20; i++) print line[i]
    if (n_lines > 20) print "and " n_lines - 20 " lines more"
    for (i = 1; i <= n_parts; i++) list = list (i > 1 ? ", " : "") parts[i]
    if (n_parts) print "what failed: " list
    print passed + 0 " passed, " failed + 0 " failed"
    exit failed > 0
}
