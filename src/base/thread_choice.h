/* thread_choice.h -- the hook by which a loop of steps gets its number of
 * threads. Without one it is that of OpenMP. */
#ifndef BASE_THREAD_CHOICE_H
#define BASE_THREAD_CHOICE_H

struct thread_choice {
    void *(*create)(void); /* its state, before the first step */
    void (*before_step)(void *choice);
    void (*after_step)(void *choice);
    void (*free)(void *choice); /* after the last step */
};

/* Ended by NULL: there is one, or none. */
extern const struct thread_choice *const thread_choices[];

/* The state that the first one creates; NULL without one. */
static inline void *thread_choice_create(void)
{
    return thread_choices[0] != 0 ? thread_choices[0]->create() : 0;
}

#endif
