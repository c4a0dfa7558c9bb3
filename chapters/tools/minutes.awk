# minutes.awk -- the plan, README.md, with the minutes that each page takes to read, by
# count: 200 words and 15 lines of code or output a minute, to five minutes.
#
#   awk -f minutes.awk chapters/README.md
#
# Replaces "62 min" in a row | [page](page.md) | question | 62 min |, and in
# <!-- hours -->15 hours<!-- --> the sum of the part that it stands in. To the steps
# belong their pages and those lines of their programs that no step before has.

function minutes(file,    line, shut, folder, list) {
    folder = file
    sub(/[^\/]*$/, "", folder)
    while ((getline line < file) > 0)
        if (line ~ /^```/) shut = !shut
        else if (shut) code++
        else if (line !~ /^<!-- (code|output|tests|table)/) words += split(line, w, " ")
    close(file)
    if (file !~ /steps\/README/) return
    list = "ls " folder "step-*.md " folder "[0-9]*.c"
    while ((list | getline file) > 0)
        if (file ~ /md$/) minutes(file)
        else while ((getline line < file) > 0) code += line != "" && !seen[line]++
    close(list)
}

{ text[NR] = $0 }

/^## / { part = $0 }

{ of[NR] = part }

/^[|] \[[^]]*\]\([^)]*[.]md\) [|].*[|] [0-9]+ min [|]/ {
    match($0, /\([^)]*[.]md\)/)
    words = code = 0
    minutes("chapters/" substr($0, RSTART + 1, RLENGTH - 2))
    took = int((words / 200 + code / 15) / 5 + 0.5) * 5
    if (took < 5) took = 5
    sub(/[|] [0-9]+ min [|]/, "| " took " min |", text[NR])
    sum[part] += took
}

END {
    for (i = 1; i <= NR; i++) {
        sub(/<!-- hours -->[0-9]* hours/,
            "<!-- hours -->" int(sum[of[i]] / 60 + 0.5) " hours", text[i])
        print text[i]
    }
}
