# table.awk -- prints the table of equations for the book, chapters/equations.md.
# A library of functions for ledger.awk, which has gathered what stands in it.

function cell(s) {
    gsub(/\n/, "<br>", s)
    return s
}

function anchor(k) {
    k = tolower(k)
    gsub(/[ .]/, "-", k)
    return k
}

function row(k,    b, s) {
    b = stands_for(k)
    s = "| <a id=\"" anchor(k) "\"></a>**" k "** " title[k]
    if (b != k)
        return s "; as [" b "](#" anchor(b) ") | | | | |"
    return s (status[k] == "done" ? "" : "; *" status[k] "*") " | " \
        cell(functions[k]) " | " cell(tests[k]) " | " cell(chapters[k]) \
        " | " evals[k] " |"
}

function table(    i, doc) {
    print "# Equations\n"
    print "Every equation of the four documents: the functions that compute it,"
    print "the tests that prove it, the sections that explain it, and the command"
    print "that evaluates it. Made by `make weave`. Their figures and tables have a page"
    print "for [each document](documents/documents.md)."
    for (i = 1; i <= n_keys; i++) {
        if (key[i] !~ "^" doc " " || doc == "") {
            doc = key[i]
            sub(/ .*/, "", doc)
            print "\n## " doc "\n\n[" doc "'s figures and tables](documents/" tolower(doc) ".md)\n"
            print "| equation | computed by | tested by | explained in | evaluate |"
            print "| --- | --- | --- | --- | --- |"
        }
        print row(key[i])
    }
}
