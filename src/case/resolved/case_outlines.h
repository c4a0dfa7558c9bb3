/* case_outlines.h -- the clumps and closed surfaces among the bodies of a case,
 * from their files, and boxes and cylinders that turn. Chapter "Resolving the
 * grains". */
#ifndef CASE_RESOLVED_CASE_OUTLINES_H
#define CASE_RESOLVED_CASE_OUTLINES_H

#include "case/settings.h"
#include "resolved/body_outline.h"

extern const char case_outlines_clumps[], case_outlines_surfaces[];

/* What the case names is read once; settings_free releases it. */
struct kept_outlines {
    int n;
    struct kept_outline {
        const char *list, *file; /* borrowed */
        double scale;            /* [-] */
        struct body_outline *outline;
    } * item;
    int touch; /* [-] 1 + what case_blocks_touch says; 0: not asked for yet */
};
void case_outlines_keep(struct settings *s);
void case_outlines_release(struct settings *s);

/* Number i of a list: of these two at its scale, NULL after a message; or of
 * case_blocks.h. */
struct body_outline *case_outlines_read(const struct settings *s,
                                        const char *list, int i);

/* The smallest and the largest radius of the balls of clump i [m]; both 0 if
 * its file cannot be read. */
void case_outlines_radii(const struct settings *s, int i, double R[2]);

/* The volume whose mass one ball or contact point carries [m^3]: of a clump the
 * largest sphere, else its volume over the points that meet a plane together;
 * HUGE_VAL if its file cannot be read. */
double case_outlines_contact_volume(const struct settings *s, const char *list,
                                    int i);

/* 0, or 2 after a message; number i of any list alone. */
int case_outlines_check_one(const struct settings *s, const char *list, int i);
int case_outlines_check(const struct settings *s);

#endif
