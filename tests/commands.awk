# The commands that a reader is told to type: the indented lines of the book that
# begin as a command does, continued lines joined, each as FILE:LINE CODE COMMAND.
# CODE is the exit code that the text promises: <!-- exit 3 --> above the lines; 0
# without one.
#
#   awk -f tests/commands.awk README.md chapters/*.md chapters/*/*.md
FNR == 1 { fenced = code = 0; command = "" }
/^```/ { fenced = !fenced }
fenced { next }
/^<!-- exit [0-9]+ -->$/ { code = $3 }
command != "" && /^    / { take(substr($0, 5)); next }
/^    (build\/winnow|build\/steps\/[0-9a-z-]+|make|sudo|sh|gnuplot|xvfb-run|mkdir|awk|cp|diff)( |$)/ {
    where = FILENAME ":" FNR
    take(substr($0, 5))
}
function take(text) {
    sub(/^ +/, "", text)
    sub(/ +#.*/, "", text)
    command = command text
    if (sub(/\\$/, "", command)) return
    print where, code + 0, command
    command = ""
    code = 0
}
