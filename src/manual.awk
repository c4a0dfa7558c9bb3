# The manual page and what a shell completes, from the program's own words:
#
#   build/winnow --help | awk -v version=0.1.0 -f src/manual.awk         winnow.1
#   { build/winnow --help; build/winnow list; } | awk -v shell=bash -f src/manual.awk
function roff(text) {
    gsub(/\\/, "\\e", text)
    gsub(/-/, "\\-", text)
    return text
}
NR == 1 { sub(/^Winnow: /, ""); sub(/\.$/, ""); about = $0 }
/^  winnow [a-z]/ {
    command[++n] = $2
    line[n] = substr($0, 3)
    for (i = 3; i <= NF; i++) { # [-s, -o of [-o DIR], --truth of [--truth
        word = $i
        gsub(/[][.|]/, "", word)
        if (word ~ /^-/) options[n] = options[n] " " word
    }
}
/^      / { what[n] = substr($0, 7) }
/^Exit codes: / { sub(/^Exit codes: /, ""); codes = $0; next }
codes != "" && !codes_end { codes = codes " " $0; codes_end = 1; next }
codes_end && /^[a-z_]+ / { kinds = kinds " " $1 }
END {
    if (shell != "") {
        print "# Completion of winnow's commands, options, kinds and cases; made by make."
        print "_winnow() {"
        print "    local word=${COMP_WORDS[COMP_CWORD]} words="
        print "    case $COMP_CWORD:${COMP_WORDS[1]} in"
        for (i = 1; i <= n; i++) all = all " " command[i]
        printf "    1:*) words='--help --version%s' ;;\n", all
        for (i = 1; i <= n; i++) {
            if (command[i] == "list") options[i] = kinds
            if (options[i] != "") printf "    *:%s) words='%s' ;;\n", command[i], substr(options[i], 2)
        }
        print "    esac"
        print "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))"
        print "}"
        print "complete -o default -F _winnow winnow"
        exit
    }
    print ".TH WINNOW 1 \"\" \"" version "\""
    print ".SH NAME\nwinnow \\- " roff(about)
    print ".SH SYNOPSIS"
    for (i = 1; i <= n; i++) print (i > 1 ? ".br\n" : "") roff(line[i])
    print ".SH COMMANDS"
    for (i = 1; i <= n; i++) print ".TP\n.B " roff(line[i]) "\n" roff(what[i])
    print ".SH EXIT STATUS\n" roff(codes)
    print ".SH SEE ALSO\n.B winnow list cases\nnames cases to begin with, and"
    print ".B winnow list keys\nwhat a case may say."
}
