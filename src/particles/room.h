/* room.h -- where a sphere may be put, others aside. */
#ifndef ROOM_H
#define ROOM_H

/* holds: 1 if a sphere of radius R [m] around x [m] is in nobody's wall; NULL:
 * in the box there is room everywhere. */
struct room {
    int (*holds)(const void *where, const double x[3], double R);
    const void *where; /* borrowed */
};

#endif
