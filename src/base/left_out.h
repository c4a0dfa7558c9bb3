/* left_out.h -- words of cases that belong to a folder which is not built.
 *
 * A build may leave folders out (`make FOLDERS=`). Their keys, models and
 * commands are then unknown, and the messages say why. The list is gathered
 * from the source of these folders by models.awk; it is empty if nothing is
 * left out.
 */
#ifndef BASE_LEFT_OUT_H
#define BASE_LEFT_OUT_H

struct left_out {
    const char *word;   /* path of a key; name of a model or of a command */
    const char *folder; /* src/room/folder */
};

/* Ended by one without a word. */
extern const struct left_out left_out_words[];

/* The folder that has the word; NULL if no folder that is left out has it. */
const char *left_out_folder(const char *word);

#endif
