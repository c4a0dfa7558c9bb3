#!/bin/sh
# The tools of the book, on a book of one page. Each fact damages something and
# looks whether the tool says what and where.
#
#   sh tests/book.sh
set -u
tools=$PWD/chapters/tools
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
facts=0

# fact NAME CODE PART COMMAND...: the command ends with the code, and what it
# prints, on either stream, holds the part.
fact() {
    name=$1 code=$2 part=$3
    shift 3
    "$@" >"$work/said" 2>&1
    found=$?
    if [ $found -ne "$code" ] || { [ -n "$part" ] && ! grep -qF -- "$part" "$work/said"; }; then
        echo "FAILED $name: exit code $found, not $code, or no \"$part\" in:"
        cat "$work/said"
        failed=$((failed + 1))
    else
        facts=$((facts + 1)) && echo "    $name"
    fi
}

# The little book, as it should be.
fresh() {
    rm -rf "$work/book" && mkdir -p "$work/book" && cd "$work/book" || exit 1
    mkdir -p src/base tests cases chapters/solutions figures
    cat >src/base/fall.c <<'END'
/* Speed after a fall from h, no air: [XS11 2.11, 2.12]. */
static double fall_speed(double g, double h)
{
    return pow(2.0 * g * h, 0.5); /* not "}" nor '{' */
}

static const int fall_tries[] = {1, 2};
END
    cat >tests/test_fall.c <<'END'
START_TEST(xs11_2_11_speed_grows_as_the_root) {
}
END_TEST

/* Both limits [XS11 2.12]. */
START_TEST(limits_are_right) {
}
END_TEST
END
    printf 'XS11 2.11 | speed | done\nXS11 2.12 | time | done\nXS11 2.13 | %s\n' \
        'heat | not yet: air' >chapters/ledger.txt
    printf '# waits\n' >chapters/pending.txt
    : >chapters/unshown.txt
    printf '# The book\n\n| 01-fall | Why does a stone fall? |\n' >chapters/README.md
    printf '# References\n\n<a id="Newton87"></a>**Newton87**\n' >chapters/references.md
    printf '# Notation\n\n| symbol | code | meaning |\n| --- | --- | --- |\n%s\n' \
        '| $g$ | `g` | gravity |' >chapters/notation.md
    printf '## part\nspeed = 4.429 [m/s]\n\n## other\nspeed = 7\n' >figures/fall.txt
    printf '| a | b |\n| --- | --- |\n| 1 | 2 |\n' >figures/map.txt
    echo '# 1 Solutions' >chapters/solutions/01-fall-solutions.md
    cat >chapters/01-fall.md <<'END'
# 1 Fall

A stone falls [Newton87]. Its speed is [XS11 (2.11), (2.12)]

$$
v = \sqrt{2 g h}. \tag{1.1}
$$

<!-- code src/base/fall.c fall_speed -->

From (1.1) it is <!-- number figures/fall.txt speed %.1f -->0<!-- --> m/s.

<!-- output figures/fall.txt part -->

<!-- tests tests/test_fall.c -->

<!-- table figures/map.txt -->

The end.

```text
<!-- code src/none.c this is text -->
```
END
    sh "$tools/weave.sh" >/dev/null && sh "$tools/ledger.sh"
}
edit() { sed -i "$1" "$2"; }
weave() { sh "$tools/weave.sh" "$@"; }
ledger() { sh "$tools/ledger.sh" check; }
text() { awk -f "$tools/text.awk" chapters/*.md $(find src -name '*.c'); }
chapter=chapters/01-fall.md

echo "weaving:"
fresh
fact a_fresh_book_is_as_the_source_says 0 "" weave check
fact a_listing_is_the_definition_with_its_comment 0 "/* Speed after" cat $chapter
fact a_number_goes_through_its_format 0 "%.1f -->4.4<!-- -->" cat $chapter
fact only_the_part_is_put_out 1 "" grep "speed = 7" $chapter
fact names_of_tests_are_listed 0 "limits_are_right" cat $chapter
fact a_table_stands_in_no_fence 0 "-->||| a | b ||| --- | --- ||| 1 | 2 |||The end." sh -c "tr '\n' '|' <$chapter"
edit 's/| 2 |/| 3 |/' figures/map.txt
fact a_changed_table_is_shown 1 "+| 1 | 3 |" weave check
fact and_is_refreshed 0 "wove $chapter" weave
fact and_then_the_old_one_is_gone 1 "" grep "| 1 | 2 |" $chapter
fresh
edit 's/0\.5)/0.6)/' src/base/fall.c
fact a_changed_exponent_names_the_chapter 1 "$chapter is not what the source says" weave check
fact a_changed_exponent_is_shown 1 "+    return pow(2.0 * g * h, 0.6)" weave check
fact weaving_refreshes_it 0 "wove $chapter" weave
fact and_then_it_is_right 0 "" weave check
fresh && edit 's/fall_speed -->/fal_speed -->/' $chapter
fact a_misspelt_name_is_told_with_chapter_and_line 1 "$chapter:9: no fal_speed in src/base/fall.c" weave
fresh && edit 's/^From (1.1) it is //' $chapter
fact a_number_cannot_begin_a_line 1 "$chapter:18: a number cannot begin a line" weave
fresh && edit 's/speed = 4.429/speed = 5.2/' figures/fall.txt
fact a_changed_result_is_shown 1 "-->5.2<!-- -->" weave check

fresh && touch figures/fall.svg
printf '\n![A stone\nthat falls](../figures/fall.svg)\n\nIt falls.\n' >>$chapter
fact a_figure_gets_its_caption 0 "wove $chapter" weave
fact the_caption_has_a_number 0 "**Figure 1.1.** A stone that falls." cat $chapter
edit 's/Figure 1.1/Figure 1.7/' $chapter
fact a_wrong_number_of_a_figure_is_shown 1 "-**Figure 1.7.**" weave check
fact and_it_is_mended 0 "wove $chapter" weave
fact once_and_not_twice 0 "" weave check

echo "text:"
fresh
fact a_fresh_text_is_right 0 "" text
edit 's/ \\tag{1.1}//; s/^A stone/\\tag{1.1} A stone/' $chapter
fact a_tag_in_prose_is_told 1 "$chapter:3: \\tag outside of \$\$" text
fresh && printf '\n$$\na\n\\tag{1.1b}\n$$\n' >>$chapter
fact the_lines_of_a_derivation_have_letters_in_order 1 "equation (1.1b) should be (1.1a)" text
fresh && edit 's/^v = .*/&\n/' $chapter
fact a_blank_line_in_a_formula_is_told 1 "$chapter:7: a blank line in a formula" text
fresh && edit 's/^v = .*/a\n+ b/' $chapter
fact a_line_like_a_list_in_a_formula_is_told 1 "$chapter:7: a line of a formula begins like a list" text
fresh && edit 's/(1.1)/(1.2)/' $chapter
fact an_equation_that_is_not_there_is_told 1 "there is no equation (1.2)" text
fresh && edit 's/Newton87/Newton88/' src/base/fall.c && edit 's/XS11 2.11, 2.12/Kepler09/' src/base/fall.c
fact an_unknown_source_is_told 1 "src/base/fall.c:1: [Kepler09] is not in references.md" text
fresh && edit 's/`g`/`gg`/' chapters/notation.md
fact a_symbol_without_code_is_told 1 "chapters/notation.md:5: no gg in src" text

echo "ledger:"
fresh
fact a_fresh_ledger_agrees 0 "" ledger
fact the_table_links_function_test_and_section 0 "(../src/base/fall.c#fall_speed) | [\`xs11_2_11" cat chapters/equations.md
edit 's/2\.11, 2\.12/2.11, 2.21/' src/base/fall.c
fact an_unknown_key_is_told_with_its_line 1 "src/base/fall.c:1: no such equation: [XS11 2.21]" ledger
fresh && edit 's/2\.11, 2\.12/2.11-2.13/' src/base/fall.c
fact computed_but_untested_is_told 1 "XS11 2.13 (heat) is \"not yet: air\" without a test" ledger
fresh && edit '/START_TEST(xs11/,/END_TEST/d' tests/test_fall.c
fact a_removed_test_is_told 1 "XS11 2.11 (speed) is \"done\" without a test" ledger
fresh && edit 's/ \[XS11 (2.11), (2.12)\]//' $chapter
fact an_unexplained_equation_is_told 1 "XS11 2.12 (time) is \"done\" without a chapter" ledger
echo 'XS11 2.11: chapter' >>chapters/pending.txt && echo 'XS11 2.12: chapter' >>chapters/pending.txt
sh "$tools/ledger.sh"
fact what_is_pending_is_only_counted 0 "2 equations still wait" ledger
edit 's/^A stone/[XS11 2.11] &/' $chapter && sh "$tools/ledger.sh"
fact what_has_come_is_taken_off 1 "" grep 2.11 chapters/pending.txt
fresh && edit 's/xs11_2_11_/xs11_2_99_/' tests/test_fall.c
fact an_unknown_key_in_a_name_is_told 1 "tests/test_fall.c:1: no such equation" ledger
fresh && edit 's/not yet: air/done/' chapters/ledger.txt
fact claimed_done_without_anything_is_told 1 "XS11 2.13 (heat) is \"done\" without a function" ledger

echo "functions, results, pages:"
fresh
fact every_function_is_shown 0 "0 of 1" sh "$tools/unshown.sh"
edit '/^<!-- code/d' $chapter
fact a_hidden_function_is_named_with_its_equation 0 \
    "src/base/fall.c:2: fall_speed [XS11 2.11, 2.12]" sh "$tools/unshown.sh" names
edit '1d' src/base/fall.c
fact a_static_function_without_an_equation_may_hide 0 "0 of 0" sh "$tools/unshown.sh"
edit 's/^static double/double/' src/base/fall.c
fact a_public_one_may_not 0 "src/base/fall.c: 1" sh "$tools/unshown.sh"
edit '$a `fall_speed` is named.' $chapter
fact it_may_be_named_in_the_text 0 "1 named" sh "$tools/unshown.sh"
echo 'src/base/fall.c fall_up' >chapters/unshown.txt
fact a_useless_exemption_is_told 1 "exempts nothing" sh "$tools/unshown.sh" check
printf '$ echo v = 4.42900000001\nv = 4.429\n' >figures/run.txt
fact last_digits_may_differ 0 "" sh "$tools/transcript.sh" check figures/run.txt
printf '$ echo v = 4.4291\nv = 4.429\n' >figures/run.txt
fact other_digits_may_not 1 "+v = 4.4291" sh "$tools/transcript.sh" check figures/run.txt
printf '$ false\nv = 4.429\n' >figures/run.txt
fact a_command_that_fails_in_silence_is_named 1 "nothing any more: false" \
    sh "$tools/transcript.sh" figures/run.txt
fact and_its_results_stay 0 "v = 4.429" cat figures/run.txt
printf '#!/bin/sh\nprintf "## one\\n1\\n## two\\n2\\n"\n' >figures/parts.sh
printf '## all\n$ sh figures/parts.sh\n## one\n0\n## two\n2\n## old\n3\n\n## last\n$ echo 4\n4\n' \
    >figures/parts.txt
sh "$tools/transcript.sh" figures/parts.txt >/dev/null 2>&1
fact parts_that_a_script_prints_are_there_once 0 "2 one two" \
    sh -c 'echo $(grep -c "## [ot]" figures/parts.txt) $(sed -n "s/^## \([ot]\)/\1/p" figures/parts.txt)'
fact a_part_of_its_own_stays_below_them 0 "## last" tail -3 figures/parts.txt
if command -v git >/dev/null; then
    git_here() { git -c user.name=a -c user.email=a@b "$@" >/dev/null 2>&1; }
    age() { sh "$tools/transcript.sh" age figures/late.txt; }
    printf '# slow: 10 s\n$ cat cases/late.cfg\n' >figures/late.txt
    echo 1 >cases/late.cfg
    git_here init && git_here add . && git_here commit -m one
    fact a_slow_transcript_without_its_revision_is_named 0 "that it does not name" age
    sh "$tools/transcript.sh" figures/late.txt >/dev/null 2>&1
    fact a_slow_transcript_tells_its_revision 0 \
        "# slow, made at $(git rev-parse --short HEAD) in 0 s: 10 s" head -1 figures/late.txt
    git_here commit -am two
    age >said
    fact it_is_not_old_if_nothing_that_it_depends_on_changed 0 "" cmp said /dev/null
    echo 2 >cases/late.cfg
    fact it_is_old_if_a_file_that_its_command_names_changed 0 "has changed" age
    sh "$tools/transcript.sh" figures/late.txt >/dev/null 2>&1
    fact what_is_made_with_changes_says_so 0 "$(git rev-parse --short HEAD)+ in 0 s: 10 s" \
        head -1 figures/late.txt
    git_here add . && git_here commit -m three
    printf '# slow\n$ cat figures/room.c cases/late.cfg\n' >figures/late.txt
    mkdir -p src/dem src/base src/fluid
    echo '#include "dem/a.h"' >figures/room.c
    echo '#include "base/b.h"' >src/dem/a.h
    touch src/base/b.h src/fluid/c.h
    git_here add . && git_here commit -m four
    sh "$tools/transcript.sh" figures/late.txt >/dev/null 2>&1
    echo 'int a;' >src/fluid/c.h
    printf '# a comment\n2\n' >cases/late.cfg
    printf '/* Why. */\n' >src/base/b.h
    age >said
    fact neither_comments_nor_other_rooms_make_a_transcript_old 0 "" cmp said /dev/null
    echo 'int b;' >src/base/b.h
    fact a_room_that_its_program_reaches_does 0 "has changed" age
    sh "$tools/transcript.sh" moved 0 figures/late.txt >said
    fact what_is_too_long_to_try_is_named 0 "has changed" cat said
    sh "$tools/transcript.sh" figures/late.txt >/dev/null 2>&1
    echo 'int c;' >src/base/b.h
    sh "$tools/transcript.sh" moved 5 figures/late.txt >said
    fact a_short_one_that_prints_the_same_is_not 0 "" cmp said /dev/null
    echo 3 >cases/late.cfg
    sh "$tools/transcript.sh" moved 5 figures/late.txt >said
    fact a_short_one_that_prints_something_else_is 0 "has changed" cat said
    printf '## dem base\n$ echo x\nx = 1.5 [-]\n\n## fluid\n$ echo y\ny = 2.5 [-]\n' \
        >figures/short-runs.txt
    git_here add . && git_here commit -m five
    sh "$tools/transcript.sh" figures/late.txt >/dev/null 2>&1
    echo 'int d;' >src/base/b.h
    sed -i 's/2.5/2.6/; s/1.5/1.5000000001/' figures/short-runs.txt
    age >said
    fact code_that_moves_no_short_run_of_its_rooms_makes_none_old 0 "" cmp said /dev/null
    sed -i 's/1.5/1.50001/' figures/short-runs.txt
    fact code_that_does_makes_it_old 0 "has changed" age
    git_here checkout figures/short-runs.txt && echo 4 >cases/late.cfg
    fact and_so_does_a_file_that_its_command_names 0 "has changed" age
    before=$(git rev-parse --short HEAD~1) # there were no short runs
    git_here checkout HEAD~1 cases/late.cfg
    sed -i "1s/.*/# slow, made at $before in 0 s/" figures/late.txt
    fact without_short_runs_the_code_is_compared 0 "has changed" age
    echo "# as at $before: dem base" >>figures/short-runs.txt
    age >said
    fact unless_they_are_known_to_be_the_first_ones 0 "" cmp said /dev/null
    sed -i 's/1.5 /1.6 /' figures/short-runs.txt
    fact which_have_moved_since 0 "has changed" age
fi
printf 'int a;  /* one */\n' >one.c
printf 'int a; /* one */\nint b; /* (1.1) */\n' >two.c
echo '(1.1) 01-fall.html' >anchors
fact a_line_that_no_step_before_has_is_marked 0 '<span id="L1"><' \
    awk -v anchors=anchors -f "$tools/steps.awk" one.c two.c
fact and_its_citation_is_a_link 0 'id="L2" class="new"><span class="kw">int</span> b; <span class="co">/* <a href="01-fall.html#eq-1-1">' \
    awk -v anchors=anchors -f "$tools/steps.awk" one.c two.c
printf '<p><a href="#a">x <a id="a">y</a></a></p>\n' >x.html
fact a_link_within_a_link_is_told 1 "x.html: a link within a link" \
    sh -c "echo x.html | awk -f '$tools/pages.awk'"
if command -v pandoc >/dev/null; then
    fresh
    fact the_book_is_rendered 0 "book: 10 pages" sh "$tools/book.sh" out
    fact equations_have_a_place 0 'id="eq-1-1"' cat out/01-fall.html
    fact they_are_linked_to 0 'href="01-fall.html#eq-1-1">(1.1)</a>' cat out/01-fall.html
    fact those_of_the_papers_lead_to_the_table 0 'href="equations.html#xs11-2-11"' cat out/01-fall.html
    fact a_dot_stands_above_its_letter_and_a_bar_over_all 0 '>˙</mo><mo accent="true">‾<' sh -c \
        'echo "$1" | awk -f "$2/tidy.awk"' - \
        '<mo accent="true">̇</mo><mo accent="true">¯</mo>' "$tools"
    fact a_listing_tells_file_and_line 0 ">src/base/fall.c, line 2</a>" cat out/01-fall.html
    printf '## part\n$ echo %s\nspeed = 4.429 [m/s]\n\n## other\nspeed = 7\n' \
        "$(yes word | head -30 | tr '\n' ' ')" >figures/fall.txt
    fact a_long_command_has_several_lines 0 'word word \' \
        sh -c "sh '$tools/book.sh' out && cat out/01-fall.html"
    fresh
    edit 's/^From/$x From/' $chapter
    fact raw_tex_is_told 1 "01-fall.html: raw TeX" sh "$tools/book.sh" out
    fresh && edit 's/^From/[here](02-none.md) &/' $chapter
    fact a_broken_link_is_told 1 "broken link: 02-none.html" sh "$tools/book.sh" out
    fresh && edit 's/^From/<b> &/' $chapter
    fact an_open_tag_is_told 1 "closes <b>" sh "$tools/book.sh" out
    fact the_contents_ask_its_question 0 "Why does a stone fall?" cat out/index.html
    fresh && echo '<svg/>' >figures/fall.svg
    printf '\n![A stone](../figures/fall.svg)\n' >>$chapter
    printf '\n| [01-fall](01-fall.md) | Why? | 5 min | 1 s | `fall` |\n' >chapters/README.md
    fact a_figure_has_a_numbered_caption 0 "<strong>Figure 1.1.</strong> A stone" \
        sh -c "sh '$tools/book.sh' out && cat out/01-fall.html"
    fact the_contents_give_times 0 "Why? (5 min to read, 1 s to run)" cat out/index.html
    fresh && cp $chapter chapters/solutions/01-fall.md
    fact two_pages_of_one_name_are_told 1 "a page of this name" sh "$tools/book.sh" out
fi

echo "tools of the book: $facts passed, $failed failed"
[ $failed -eq 0 ]
