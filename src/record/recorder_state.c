/* SPDX-License-Identifier: GPL-3.0-or-later */
/* recorder_state.c -- the visit of all output.  Chapter "Nothing is lost". */
#include "record/recorder_internal.h"

#include "base/clock.h"
#include "coupling/processes.h"

static void recorder_state_sums(struct recorder *r, struct state *s)
{
    double elapsed = clock_now() - r->began;

    state_real(s, "elapsed", "s", &elapsed);
    r->began = clock_now() - elapsed;
    state_real(s, "worst_mass", "-", &r->worst_mass);
    state_real(s, "worst_momentum", "-", &r->worst_momentum);
    state_real(s, "worst_exchange", "-", &r->worst_exchange);
    state_real(s, "worst_overlap", "-", &r->worst_overlap);
    state_real(s, "worst_cfl", "-", &r->worst_cfl);
    state_real(s, "eps_lowest", "-", &r->eps_lowest);
    state_long(s, "capped_steps", "-", &r->capped_steps);
}

/* The folder is visited last: it removes later files only after all others have
 * been found. */
void recorder_state(struct recorder *r, struct state *s)
{
    state_begin(s, "recorder");
    recorder_state_sums(r, s);
    if (r->sim->processes == NULL)
        snapshot_state(r->snapshot, r->sim->mesh, s);
    else if (s->loading)
        recorder_take_snapshots(r);
    table_state(r->history, s);
    MODELS_EACH(r->parts.part, state, r->parts.state[i_model], s);
    field_output_state(r->pictures, s);
    folder_state(r->folder, s);
    state_end(s);
}
