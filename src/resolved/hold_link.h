/* hold_link.h -- what a body does to a cell. Chapter "Resolving the grains". */
#ifndef RESOLVED_HOLD_LINK_H
#define RESOLVED_HOLD_LINK_H

/* A cell that a body holds, or, outside of it, one beside a held one. */
struct hold_link {
    int cell;
    double hold; /* [kg/(m^3 s)]; by_fraction: solid fraction [-] */
    double u[3]; /* [m/s] velocity of the body there */
    double r[3]; /* [m] the cell's centre, from that of the body */
};

#endif
