# The files of a report's page as lines of C, in pieces, for a string has an end:
#
#   awk -f parts.awk page_html=src/report/page.html page_css=... ; a file that is not
#   there is an array without lines.
function pieces(line,    i, s) {
    for (i = 1; i == 1 || i <= length(line); i += 2000) {
        s = substr(line, i, 2000)
        gsub(/[\\"?]/, "\\\\&", s)
        printf "\"%s%s\",\n", s, (i + 2000 > length(line) ? "\\n" : "")
    }
}
BEGIN {
    print "#include \"report/page.h\""
    for (k = 1; k < ARGC; k++) {
        at = index(ARGV[k], "=")
        print "const char *const " substr(ARGV[k], 1, at - 1) "[] = {"
        file = substr(ARGV[k], at + 1)
        while ((getline line <file) > 0) pieces(line)
        print "0};"
    }
}
